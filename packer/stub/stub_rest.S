// Part of all stubs: the code that they share. The payload section follows in the file.

// mixIn(eax, edx) -> eax; clobbers edx.
mix_in:
    lea eax, [rax + rdx + 1]
    imul eax, eax, HASH
    mov edx, eax
    shr edx, HASH_SHIFT
    xor eax, edx
    ret

#include "stub_decode.S"
#include "stub_parse.S"

runs:
#define OPCODE_RUN(count, kind) .byte (count) << CLASS_BITS | (kind);
#include "packer/model/opcodes.h"
runs_end:
    .long MOST_BITS // the constants MOST .. SCALE, in this order
    .long MOST_BITS | 0x80000000 // negative
    .long ONE_BITS
    .long SETTLED0_BITS
    .long SETTLED1_BITS
    .long SETTLED2_BITS
    .long EARLY_USES_BITS
    .long EARLY_LEARNING_BITS
    .long LEARNING_BITS
    .long FINAL_LEARNING_BITS
    .long STEEPNESS_BITS
    .long MIDDLE_BITS
    .long SCALE_BITS
payload_header:

// For the packer's check: void STUB_DECODE(header, image, memory)
.text
.globl STUB_DECODE
STUB_DECODE:
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
.section .note.GNU-stack, "", @progbits
