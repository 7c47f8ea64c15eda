// The code in front of every program packed for Windows: checks the file, decodes the program, starts it. What
// stub.S does on Linux, by the same decoder, with the functions of kernel32.dll that the file imports (Start in
// pe_format.h). These are called by Microsoft's convention: 32 bytes of stack belong to them. Decoder and program
// keep to System V's. What it finds, does and leaves is described in pe_format.h, where its texts are, too.

#include "stub_memory.S"

// Slots of what is imported, in their order; the first two are those that the program wants
#define IMPORT(number) [rip + start - PE_START + 8 * (number)]
#define LOAD_LIBRARY IMPORT(2)
#define GET_PROC_ADDRESS IMPORT(3)
#define VIRTUAL_ALLOC IMPORT(4)
#define VIRTUAL_FREE IMPORT(5)
#define VIRTUAL_PROTECT IMPORT(6)
#define GET_STD_HANDLE IMPORT(7)
#define WRITE_FILE IMPORT(8)
#define EXIT_PROCESS IMPORT(9)
#define FRONT rip + start - PE_START - PAGE

.section .stub, "ax"
start:
    sub rsp, 40 // aligned to 16, as everywhere below
    lea ebx, [rip + parameters]

    // Check all of the section that comes behind the slots. How long it is the header says, as the loader has
    // checked it
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

    mov edx, [rbx + MEMORY] // rcx is 0: anywhere
    mov r8d, 0x3000 // reserve, commit
    push 4 // read, write
    pop r9
    call VIRTUAL_ALLOC
    test rax, rax
    je no_memory
    push rax // to give it back
    lea rbp, [rax - FIELDS]
    mov r12d, [rbx + IMAGE]
    call give_imports // for the early part
    call decode
    call give_imports // decoding has gone over them
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
    lea rsi, IMPORT(0)
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
    lea r9, [rsp + 32] // what they were
    call VIRTUAL_PROTECT
    add rsp, 40
    test eax, eax
    je 1f
    ret
1:  push PE_GUARDED
    jmp refuse
damaged:
    push PE_DAMAGED
    jmp refuse
no_memory:
    push PE_NO_MEMORY

// On standard error; where there is none, in a box.
refuse:
    pop rsi
    lea edi, [FRONT + PE_TEXTS]
    add esi, edi
    and rsp, -16
    sub rsp, 48
    push -12 // standard error
    pop rcx
    call GET_STD_HANDLE
    mov rcx, rax
    mov rdx, rsi
    push PE_TEXT // its size
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
    push 0x10 // an error's sign
    pop r9
    call rax
1:  push 1
    pop rcx
    call EXIT_PROCESS

#define STUB_DECODE stubDecodeWindows
#include "stub_rest.S"
