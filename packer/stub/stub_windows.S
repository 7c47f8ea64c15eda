// The stub of programs packed for Windows: it checks the file, decodes the program and starts it. It does the same as
// stub.S on Linux, with the same decoder, and with the functions of kernel32.dll that the file imports (PeStart in
// pe_format.h). They use Microsoft's calling convention: the caller reserves 32 bytes of stack for them. Decoder and
// program use System V's. pe_format.h describes its input, its actions and its results. The texts are in the headers.

#include "stub_memory.S"

// Slots of the imports
#define IMPORT(number) [rip + start - PE_START + 8 * (number)]
#define LOAD_LIBRARY IMPORT(PE_LOAD_LIBRARY)
#define GET_PROC_ADDRESS IMPORT(PE_GET_PROC_ADDRESS)
#define VIRTUAL_ALLOC IMPORT(PE_VIRTUAL_ALLOC)
#define VIRTUAL_FREE IMPORT(PE_VIRTUAL_FREE)
#define VIRTUAL_PROTECT IMPORT(PE_VIRTUAL_PROTECT)
#define GET_STD_HANDLE IMPORT(PE_GET_STD_HANDLE)
#define WRITE_FILE IMPORT(PE_WRITE_FILE)
#define EXIT_PROCESS IMPORT(PE_EXIT_PROCESS)
#define FRONT rip + start - PE_START - PAGE

.section .stub, "ax"
start:
    sub rsp, 40 // aligned to 16, as everywhere below
    lea ebx, [rip + payload_header]

    // Check the section after the slots. Its size comes from the header, which the loader has checked
    mov ecx, [FRONT + PE_FILE_SIZE]
    shr ecx, 2
    sub ecx, PE_SLOTS / 4
    lea esi, [rip + start - PE_START + PE_SLOTS]
    xor ebp, ebp
1:  lodsd
    add ebp, eax
    imul ebp, ebp, HASH
    loop 1b
    test ebp, ebp
    jne damaged

    mov edx, [rbx + MEMORY] // rcx is 0: at any address
    mov r8d, 0x3000 // reserve, commit
    push 4 // read, write
    pop r9
    call VIRTUAL_ALLOC
    test rax, rax
    je no_memory
    push rax // for VirtualFree
    lea rbp, [rax - FIELDS]
    mov r12d, [rbx + IMAGE]
    call give_imports // for the early part
    call decode
    call give_imports // decoding has overwritten them
    pop r12
    mov esi, [rbx + READ_ONLY]
    call protect
    mov rcx, r12
    xor edx, edx
    mov r8d, 0x8000 // release
    call VIRTUAL_FREE
    add rsp, 40
    mov eax, [rbx + ENTRY]
    jmp rax

give_imports:
    mov edi, [rbx + IMPORTS]
    lea rsi, IMPORT(PE_PROGRAM1)
    movsq
    movsq
    ret

// Makes esi bytes of the image R-X.
protect:
    sub rsp, 40
    mov ecx, [rbx + IMAGE]
    mov edx, esi
    push 0x20 // execute, read
    pop r8
    lea r9, [rsp + 32] // where VirtualProtect writes the old protection
    call VIRTUAL_PROTECT
    add rsp, 40
    test eax, eax
    je 1f
    ret
1:  push PE_MAY_NOT_RUN
    jmp refuse
damaged:
    push PE_DAMAGED
    jmp refuse
no_memory:
    push PE_NO_MEMORY

// Writes to standard error; if there is none, shows a message box.
refuse:
    pop rsi
    lea edi, [FRONT + PE_MESSAGES]
    add esi, edi
    and rsp, -16
    sub rsp, 48
    push -12 // standard error
    pop rcx
    call GET_STD_HANDLE
    mov rcx, rax
    mov rdx, rsi
    push PE_MESSAGE // the text's size
    pop r8
    lea r9, [rsp + 40]
    and qword ptr [rsp + 32], 0
    call WRITE_FILE
    test eax, eax
    jne 1f
    lea ecx, [rdi + PE_USER32]
    call LOAD_LIBRARY
    lea edx, [rdi + PE_MESSAGE_BOX]
    mov rcx, rax
    call GET_PROC_ADDRESS
    xor ecx, ecx
    mov rdx, rsi
    mov r8, rsi
    push 0x10 // MB_ICONERROR
    pop r9
    call rax
1:  push 1
    pop rcx
    call EXIT_PROCESS

#define STUB_DECODE stubDecodeWindows
#include "stub_rest.S"
