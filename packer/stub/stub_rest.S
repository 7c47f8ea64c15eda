// Part of all stubs: the code that they share. The payload section follows in the file.

// mixIn(eax, edx) -> eax; clobbers edx.
mix_in:
    lea eax, [rax + rdx + 1]
    imul eax, eax, kHash
    mov edx, eax
    shr edx, kHashShift
    xor eax, edx
    ret

#include "stub_decode.S"
#include "stub_parse.S"

runs:
#define OPCODE_RUN(count, kind) .byte (count) << kClassBits | (kind);
#include "packer/model/opcodes.h"
runs_end:
    // The constants MOST .. SCALE, in this order
    .long kMostSum, kMostSum | 0x80000000, kOne, kSettled0, kSettled1, kSettled2, kEarlyUses, kEarlyLearning, kLearning
    .long kFinalLearning, kSteepness, kMiddle, kScale
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
