// The stub of programs packed for Windows: it checks the file, decodes the program and starts it. It does the same as
// stub.S on Linux, with the same decoder, and with the functions of kernel32.dll that the file imports (PeStart in
// pe_format.h). They use Microsoft's calling convention: the caller reserves 32 bytes of stack for them. Decoder and
// program use System V's. pe_format.h describes its input, its actions and its results. The texts are in the headers.

#include "stub_memory.S"

// Slots of the imports
#define IMPORT(number) [rip + start - sizeof_PeStart + 8 * (number)]
#define FRONT rip + start - sizeof_PeStart - kPage

.section .stub, "ax"
start:
    sub rsp, 40 // aligned to 16, as everywhere below
    lea ebx, [rip + payload_header]

    // Check the section after the slots. Its size comes from the header, which the loader has checked
    mov ecx, [FRONT + front_fileSize]
    shr ecx, 2
    sub ecx, sizeof_slots / 4
    lea esi, [rip + start - sizeof_PeStart + sizeof_slots]
    xor ebp, ebp
1:  lodsd
    add ebp, eax
    imul ebp, ebp, kHash
    loop 1b
    test ebp, ebp
    jne damaged

    mov edx, [rbx + header_memory] // rcx is 0: at any address
    mov r8d, 0x3000 // reserve, commit
    SET_SMALL(r9, 4) // read, write
    call IMPORT(kPeVirtualAlloc)
    test rax, rax
    je no_memory
    push rax // for VirtualFree
    lea rbp, [rax - FIELDS]
    mov r12d, [rbx + header_image]
    call give_imports // for the early part
    call decode
    call give_imports // decoding has overwritten them
    pop r12
    mov esi, [rbx + header_readOnly]
    call protect
    mov rcx, r12
    xor edx, edx
    mov r8d, 0x8000 // release
    call IMPORT(kPeVirtualFree)
    add rsp, 40
    mov eax, [rbx + header_entry]
    jmp rax

give_imports:
    mov edi, [rbx + header_imports]
    lea rsi, IMPORT(kPeProgram1)
    movsq
    movsq
    ret

// Makes esi bytes of the image R-X.
protect:
    sub rsp, 40
    mov ecx, [rbx + header_image]
    mov edx, esi
    SET_SMALL(r8, 0x20) // execute, read
    lea r9, [rsp + 32] // where VirtualProtect writes the old protection
    call IMPORT(kPeVirtualProtect)
    add rsp, 40
    test eax, eax
    je 1f
    ret
1:  push message_mayNotRun
    jmp refuse
damaged:
    push message_damaged
    jmp refuse
no_memory:
    push message_noMemory

// Writes to standard error; if there is none, shows a message box.
refuse:
    pop rsi
    lea edi, [FRONT + front_messages]
    add esi, edi
    and rsp, -16
    sub rsp, 48
    SET_SMALL(rcx, -12) // standard error
    call IMPORT(kPeGetStdHandle)
    mov rcx, rax
    mov rdx, rsi
    SET_SMALL(r8, kMessage) // the text's size
    lea r9, [rsp + 40]
    and qword ptr [rsp + 32], 0
    call IMPORT(kPeWriteFile)
    test eax, eax
    jne 1f
    lea ecx, [rdi + message_user32]
    call IMPORT(kPeLoadLibrary)
    lea edx, [rdi + message_messageBox]
    mov rcx, rax
    call IMPORT(kPeGetProcAddress)
    xor ecx, ecx
    mov rdx, rsi
    mov r8, rsi
    SET_SMALL(r9, 0x10) // MB_ICONERROR
    call rax
1:  SET_SMALL(rcx, 1)
    call IMPORT(kPeExitProcess)

#define STUB_DECODE stubDecodeWindows
#include "stub_rest.S"
