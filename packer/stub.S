// The code in front of every packed program: checks the file, decodes the program, starts it. Position-
// independent, baseline x86-64, no library.
//
// In assembler, because it is part of every packed file: 1.9 KB, where g++ -Os makes 3.7 KB of the same in C++.
// It does what decoder.h, model.h and x86.h say, whose names it uses; the packer runs both before it
// writes a file. Parameters are described in format.h.
//
// Registers while decoding: rbx parameters, rbp within the model's memory, r12 the next byte of the image, r13
// the same in the copy of coded bytes, r14 the payload; r11d the byte so far (bits), r8 the slots. Subroutines
// clobber what they like of the rest.

.intel_syntax noprefix

// --- Parameters, from rbx ---
.set FILE, 0
.set WORDS, 4
.set IMAGE, 8
.set READ_ONLY, 12
.set IMPORTS, 16
.set ENTRY, 20
.set EARLY, 24
.set EARLY_ENTRY, 28
.set SIZE, 32
.set CODE_BEGIN, 36
.set CODE_SIZE, 40
.set MEMORY, 44
.set CONTEXTS, 48
.set SHIFT, 49
.set MASKS, 50
// Before them
.set MOST, -36
.set LEAST, -32
.set ONE, -28
.set SETTLED, -24
.set LEARNING, -20
.set FINAL_LEARNING, -16
.set STEEPNESS, -12
.set MIDDLE, -8
.set CERTAIN, -4

// --- The model's memory, from rbp ---
.set FIELDS, -112
.set WHERE, FIELDS
.set INSTRUCTION1, FIELDS + 4 * 8
.set OPCODE1, FIELDS + 4 * 9
.set OPCODE2, FIELDS + 4 * 10
.set MODRM1, FIELDS + 4 * 12
.set OPCODE, FIELDS + 4 * 13
.set MODRM, FIELDS + 4 * 14
.set MODE, FIELDS + 4 * 15
.set SO_FAR, FIELDS + 4 * 16
.set PHASE, FIELDS + 4 * 17
.set LEFT, FIELDS + 4 * 18
.set WIDE, FIELDS + 4 * 19
.set IMMEDIATE, FIELDS + 4 * 20
.set RELATIVE, FIELDS + 4 * 21
.set MAP, FIELDS + 4 * 22
.set RANGE, FIELDS + 4 * 23
.set CODE, FIELDS + 4 * 24
.set POSITION, FIELDS + 4 * 25
.set TYPE, FIELDS + 4 * 26
.set RESULTS, 0
.set ROWS, RESULTS + 4 * 8
.set HASHES, ROWS + 8 * 8
.set INPUTS, HASHES + 4 * 32
.set COUNTERS, INPUTS + 4 * 72
.set BYTE_SLOTS, COUNTERS + 8 * 74
.set OPCODES, BYTE_SLOTS + 8 * 24
.set FINAL_WEIGHTS, OPCODES + 1024
.set WEIGHTS, FINAL_WEIGHTS + 4 * 8
.set ROW, 4 * 72
.set CORRECTIONS, WEIGHTS + 8 * 4096 * ROW
.set HISTORIES, CORRECTIONS + 4 * 65536 * 32
.set CONTEXT, 4 * (256 + 65536)
.set SLOTS, HISTORIES + 24 * CONTEXT
// The slots follow, then eight zeros and the coded bytes

.set HASH, 0x2c9277b5 // kHash

.section .stub, "ax"
start:
    push rdx // ld.so's function for exit, which the program wants to see
    push rsi
    lea rbx, [rip + parameters]

    // Check the file. A page that it is too short for must not be touched: access() says which
    mov edi, [rbx + FILE]
    mov r12d, [rbx + WORDS]
    xor esi, esi
    xor ebp, ebp
1:  test di, 0xfff
    jne 2f
    push 21 // access
    pop rax
    syscall
    cmp al, -14 // EFAULT
    je damaged
2:  add ebp, [rdi]
    imul ebp, ebp, HASH
    scasd
    dec r12d
    jne 1b
    test ebp, ebp
    je get_memory
damaged: // the texts stand here, so that a file cut short still has them; both 23 long
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
    push 3 // read, write
    pop rdx
    push 0x22 // private, anonymous
    pop r10
    xor r9d, r9d
    push 9 // mmap
    pop rax
    syscall
    test rax, rax
    js no_memory
    push rax // to give it back
    lea rbp, [rax - FIELDS]

    // Decode; what the loader has found for the program stays
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

// Makes esi bytes of the image R-X.
protect:
    mov edi, [rbx + IMAGE]
    push 5 // read, execute
    pop rdx
    push 10 // mprotect
    pop rax
    syscall
    ret

// mixIn(eax, edx) -> eax; clobbers edx.
mix_in:
    lea eax, [rax + rdx + 1]
    imul eax, eax, HASH
    mov edx, eax
    shr edx, 15
    xor eax, edx
    ret

#include "stub_decode.S"
#include "stub_parse.S"

runs:
#define OPCODE_RUN(count, kind) .byte (count) << 3 | (kind);
#include "opcodes.h"
runs_end:
    .long 0x4cfdea11 // 11 / kLogUnit
    .long 0xccfdea11
    .float 1
    .long 0x3f8ccccd // 1.1
    .long 0x300df4e0 // kLearning
    .long 0x2eb17218 // kFinalLearning
    .long 0x33ddce9e // 1.25 * kLogUnit
    .float 16
    .float 16777216
parameters:

// For the packer's check: void stubDecode(parameters, image, memory)
.text
.globl stubDecode
stubDecode:
    push rbx
    push rbp
    push r12
    push r13
    push r14
    push r15
    mov rbx, rdi
    mov r12, rsi
    lea rbp, [rdx - FIELDS]
    call decode
    pop r15
    pop r14
    pop r13
    pop r12
    pop rbp
    pop rbx
    ret
.section .rodata
.globl kStubMemory
kStubMemory:
    .long SLOTS - FIELDS
.section .note.GNU-stack, "", @progbits
