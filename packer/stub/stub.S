// The stub of programs made for packing: it checks the file, decodes the program and starts it. Baseline x86-64,
// position-independent, no library.
//
// It is part of every packed file, so it is written in assembler: 2.5 KB, half of what g++ -Os makes of the C++.
// It does the same as decoder.h, model.h and x86.h and uses their names. The packer runs both versions before it writes
// a file. format.h describes its input, its actions and its results. Numbers of C++ come from stub_numbers.cpp. Other
// numbers are offsets in its own memory, the kernel's calls and x86 opcodes, as in x86.h.
//
// Registers while decoding: rbx points to the payload header, rbp into the model's memory, r8 to the slots, r12 to the
// next byte of the image, r13 to the same byte in the array of coded bytes, r14 to the next byte of the payload; r11d
// is the byte so far (bits). Subroutines may clobber all other registers.

#include "stub_memory.S"
#include "stub_linux.S"

.section .stub, "ax"
start:
    push rdx // the function to call at exit, which ld.so passes to the program
    push rsi
    lea ebx, [rip + payload_header]

    // The headers are not checked yet, so compute the file's beginning from the address of this code
    lea edi, [rip + start - sizeof_Front]
    check_file
damaged: // the texts are here because a truncated file still has this part; each text has 23 bytes
    call refuse
    .ascii "damaged: copy it again\n"
no_memory:
    call refuse
    .ascii "not enough free memory\n"
refuse:
    pop rsi
    SET_SMALL(rdx, 23)
    SET_SMALL(rax, 1) // write
    SET_SMALL(rdi, 2)
    syscall
    SET_SMALL(rax, 60) // exit
    dec edi // 1
    syscall

get_memory:
    xor edi, edi
    mov esi, [rbx + header_memory]
    map_memory
    js no_memory
    push rax // for munmap
    lea rbp, [rax - FIELDS]
    large_pages

    // Decode. Decoding overwrites the slots of the imports, so save them before and restore them afterwards
    mov edi, [rbx + header_imports]
    push [rdi]
    push [rdi + 8]
    mov r12d, [rbx + header_image]
    call decode
    mov edi, [rbx + header_imports]
    pop [rdi + 8]
    pop [rdi]

    mov esi, [rbx + header_readOnly]
    call protect
    pop rdi
    mov esi, [rbx + header_memory]
    SYSTEM_CALL(11) // munmap
    pop rsi
    pop rdx
    mov eax, [rbx + header_entry]
    jmp rax

// Makes esi bytes of the image R-X, unless the system forbids it (SELinux, systemd's MemoryDenyWriteExecute).
protect:
    mov edi, [rbx + header_image]
    SET_SMALL(rdx, 5) // read, execute
    SYSTEM_CALL(10) // mprotect
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
