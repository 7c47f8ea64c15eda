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
.irp register, rbx, rbp, r12, r13, r14, r15
    push \register
.endr
    mov rbx, rdi
    mov r12, rsi
    lea rbp, [rdx - FIELDS]
    call decode
.irp register, r15, r14, r13, r12, rbp, rbx
    pop \register
.endr
    ret
.section .note.GNU-stack, "", @progbits
