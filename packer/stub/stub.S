// The code in front of every packed program: checks the file, decodes the program, starts it. Position-
// independent, baseline x86-64, no library.
//
// It is in assembler because it is part of every packed file: it has 2.5 KB, half of what g++ -Os makes of C++. It
// does what decoder.h, model.h and x86.h do, and uses their names. The packer runs both versions before it writes a
// file. format.h describes its input, its actions and its results. Numbers shared with C++ come from stub_numbers.h.
// Other numbers are offsets in its own memory, the kernel's calls and x86 opcodes, as in x86.h.
//
// Registers while decoding: rbx the payload header, rbp a place within the model's memory, r12 the next byte of the
// image, r13 the same in the copy of coded bytes, r14 the next byte of the payload; r11d the byte so far (bits), r8 the
// slots. Subroutines may clobber all other registers.

#include "stub_memory.S"
#include "stub_linux.S"

.section .stub, "ax"
start:
    push rdx // ld.so's function for exit, which the program gets
    push rsi
    lea ebx, [rip + payload_header]

    // Nothing is trusted before it is checked, so the file's beginning is computed from this code's own address
    lea edi, [rip + start - FRONT]
    check_file
damaged: // the texts are here so that a truncated file still has them; each is 23 bytes long
    call refuse
    .ascii "damaged: get it afresh\n"
no_memory:
    call refuse
    .ascii "not enough free memory\n"
refuse:
    pop rsi
    push 23
    pop rdx
    push 1 // write
    pop rax
    push 2
    pop rdi
    syscall
    push 60 // exit
    pop rax
    dec edi // 1
    syscall

get_memory:
    xor edi, edi
    mov esi, [rbx + MEMORY]
    map_memory
    js no_memory
    push rax // for munmap
    lea rbp, [rax - FIELDS]
    large_pages

    // Decode. Decoding overwrites the slots of the imports, so save them around it
    mov edi, [rbx + IMPORTS]
    push [rdi]
    push [rdi + 8]
    mov r12d, [rbx + IMAGE]
    call decode
    mov edi, [rbx + IMPORTS]
    pop [rdi + 8]
    pop [rdi]

    mov esi, [rbx + READ_ONLY]
    call protect
    pop rdi
    mov esi, [rbx + MEMORY]
    push 11 // munmap
    pop rax
    syscall
    pop rsi
    pop rdx
    mov eax, [rbx + ENTRY]
    jmp rax

// Makes esi bytes of the image R-X. The kernel refuses where memory that was written may not become executable
// (SELinux, systemd's MemoryDenyWriteExecute).
protect:
    mov edi, [rbx + IMAGE]
    push 5 // read, execute
    pop rdx
    push 10 // mprotect
    pop rax
    syscall
    test eax, eax
    jns 1f
    call refuse
    .ascii "it may not run packed.\n"
1:  ret

#define STUB_DECODE stubDecode
#include "stub_rest.S"
.section .rodata
.globl kStubMemory
kStubMemory:
    .long SLOTS - FIELDS
