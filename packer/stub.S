// The code in front of every packed program: checks the file, decodes the program, starts it. Position-
// independent, baseline x86-64, no library.
//
// In assembler, because it is part of every packed file: 1.3 KB, where a compiler makes 3.3 KB of the same in
// C++. It does what decoder.h, model.h and x86.h say, whose names it uses; the packer runs both before it
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

.set HASH, 0x2c9277b5

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

// ---------------------------------------------------------------------------------------------------------
decode:
    // expandOpcodes, and the weights, which lie behind
    lea rdi, [rbp + OPCODES]
    lea rsi, [rip + runs]
    push runs_end - runs
    pop rdx
1:  lodsb
    mov ecx, eax
    and al, 7
    shr cl, 3
2:  stosb
    dec cl
    jne 2b
    dec edx
    jne 1b
    mov ecx, 8 + 8 * 4096 * 72
    mov eax, 0x3d800000 // kFirstWeight
    rep stosd

    inc dword ptr [rbp + RANGE]
    mov eax, [rbx + MEMORY]
    sub eax, [rbx + SIZE]
    lea r13, [rbp + rax + FIELDS]
    movzx eax, byte ptr [rbx + CONTEXTS]
    lea r14, [rbx + rax * 4 + MASKS + 4 * 7]

    xor eax, eax
next_byte: // eax is the position
    test eax, 0x7ff
    jne 1f
    cmp eax, [rbx + EARLY]
    jb 1f
    // The early part: (stack at the program's start, bytes done, bytes in all)
    mov esi, [rbx + EARLY]
    call protect
    lea rdi, [rsp + 48]
    mov esi, [rbp + POSITION]
    mov edx, [rbx + SIZE]
    mov eax, [rbx + EARLY_ENTRY]
    call rax
1:
    // Fields
    lea rdi, [rbp + FIELDS]
    mov eax, [rbp + LEFT]
    shl eax, 3
    or eax, [rbp + PHASE]
    stosd
    push 6
    pop rcx
    mov rsi, r13
1:  dec rsi
    movzx eax, byte ptr [rsi]
    stosd
    loop 1b
    mov edx, [rbp + POSITION]
    mov eax, edx
    and eax, 3
    stosd

    // begin
    lea rsi, [rbx + MASKS]
    mov cl, [rbx + CONTEXTS] // rcx was 0
    add ecx, 7
    sub edx, [rbx + CODE_BEGIN]
    cmp edx, [rbx + CODE_SIZE]
    sbb edi, edi
    inc edi // 1 in data
    mov [rbp + TYPE], edi
    je 1f
    lea rsi, [rsi + rcx * 2]
1:  mov r8d, edi
    lea rdi, [rbp + HASHES]
hash_next:
    lodsw
    movzx r9d, ax
    lea eax, [rcx + r8]
    mov edx, [rbp + WHERE]
    call mix_in
    lea r10, [rbp + FIELDS]
1:  add r10, 4
    shr r9d, 1
    jnc 2f
    mov edx, [r10]
    call mix_in
2:  test r9d, r9d
    jne 1b
    stosd
    loop hash_next

    push 1
    pop r11

next_bit:
    lea r8, [rbp + SLOTS]
    // predict: find the counters
    movzx r10d, byte ptr [rbx + CONTEXTS]
    lea rsi, [rbp + HASHES]
    lea rdi, [rbp + COUNTERS]
    lea r9, [rbp + BYTE_SLOTS]
    lea r15, [rbp + HISTORIES]
find:
    lodsd
    mov edx, r11d
    call mix_in
    mov edx, eax // check in its low half
    mov cl, [rbx + SHIFT]
    shr eax, cl
    lea rax, [r8 + rax * 8]
    cmp [rax + 6], dx
    je 2f
    mov rcx, rax
    xor cl, 8
    cmp [rcx + 6], dx
    je 1f
    push rdx
    mov dl, [rax + 4]
    cmp [rcx + 4], dl
    pop rdx
    cmovae rcx, rax
    shl rdx, 48
    mov [rcx], rdx
1:  mov rax, rcx
2:  stosq
    mov rcx, rax
    movzx eax, byte ptr [rcx + 4]
    lea rax, [r15 + rax * 4]
    stosq
    cmp r11d, 1
    jne 3f
    mov [r9], rcx
3:  mov rcx, [r9]
    add r9, 8
    xor eax, eax
    mov ah, [rcx + 5]
    mov al, r11b
    lea rax, [r15 + rax * 4 + 1024]
    stosq
    add r15, CONTEXT
    dec r10d
    jne find
    push rdi // where the correction's counter goes
    push rsi // hashes of the selectors
    mov r9, rsi

    // stretch
    call point_to_inputs
    mov rdi, rsi
    lea rsi, [rbp + COUNTERS]
1:  lodsq
    mov eax, [rax]
    sar eax, 8
    mov edx, 0x800001
    sub edx, eax
    cvtsi2ss xmm1, edx
    add eax, 0x800001
    cvtsi2ss xmm0, eax
    psubd xmm0, xmm1
    cvtdq2ps xmm0, xmm0
    movd eax, xmm0
    stosd
    loop 1b

    // Mix
    push 8
    pop r10
    mov eax, r11d
1:  lea eax, [r10 + rax * 8] // rows of the eight sets lie together
    imul eax, eax, ROW
    lea rdx, [rbp + rax + WEIGHTS - ROW]
    mov [rbp + r10 * 8 + ROWS - 8], rdx
    call point_to_inputs
    call mix
    movss [rbp + r10 * 4 + RESULTS - 4], xmm0
    mov eax, [r9]
    add r9, 4
    shr eax, 20
    dec r10d
    jne 1b
    call point_to_results
    call mix
    movaps xmm5, xmm0
    call squash
    movaps xmm4, xmm0 // mixed, until learn

    // Correct
    pop rsi
    lodsd
    mov edx, r11d
    call mix_in
    shr eax, 11 // 65536 rows of 32
    and al, 0xe0
    mulss xmm5, [rbx + STEEPNESS]
    addss xmm5, [rbx + MIDDLE]
    cvttss2si edx, xmm5
    add eax, edx
    lea rax, [rbp + rax * 4 + CORRECTIONS]
    pop rdi
    mov [rdi], rax
    mulss xmm0, [rbx + CERTAIN]
    cvttss2si edx, xmm0
    cmp dword ptr [rax], 0
    jne 1f
    lea ecx, [rdx - 0x800000]
    shl ecx, 8
    mov cl, 20 // kFirstTrust
    mov [rax], ecx
1:  mov eax, [rax]
    sar eax, 8
    lea eax, [rax + rdx + 0x800000]
    shr eax, 5
    or al, 1

    // Decoder::bit
1:  cmp byte ptr [rbp + RANGE + 3], 0
    jne 2f
    shl dword ptr [rbp + RANGE], 8
    shl dword ptr [rbp + CODE], 8
    mov cl, [r14]
    inc r14
    mov [rbp + CODE], cl
    jmp 1b
2:  mov edx, [rbp + RANGE]
    imul rax, rdx
    shr rax, 20
    sub edx, eax
    mov ecx, [rbp + CODE]
    cmp ecx, eax
    sbb r9d, r9d
    jb 3f
    sub ecx, eax
    mov eax, edx
3:  mov [rbp + CODE], ecx
    mov [rbp + RANGE], eax
    neg r9d // the bit

    // learn: the weights
    cvtsi2ss xmm3, r9d
    push 8
    pop r10
1:  movss xmm0, [rbp + r10 * 4 + RESULTS - 4]
    call squash
    movaps xmm1, xmm3
    subss xmm1, xmm0
    mulss xmm1, [rbx + LEARNING]
    mov rdx, [rbp + r10 * 8 + ROWS - 8]
    call point_to_inputs
    call train
    dec r10d
    jne 1b
    movaps xmm1, xmm3
    subss xmm1, xmm4
    mulss xmm1, [rbx + FINAL_LEARNING]
    call point_to_results
    call train

    // ... the counters, that of the correction too
    lea rsi, [rbp + COUNTERS]
    lea r10d, [r9 - 1]
    xor r10d, 0x7fffff
    movzx ecx, byte ptr [rbx + CONTEXTS]
    lea r8d, [rcx + rcx * 2 + 1]
1:  lodsq
    movzx ecx, byte ptr [rax]
    cvtsi2ss xmm1, ecx
    addss xmm1, [rbx + SETTLED]
    mov edx, [rax]
    sar edx, 8
    mov edi, r10d
    sub edi, edx
    cvtsi2ss xmm0, edi
    divss xmm0, xmm1
    cvttss2si edi, xmm0
    add edx, edi
    shl edx, 8
    add cl, 1
    sbb cl, 0
    mov dl, cl
    mov [rax], edx
    dec r8d
    jne 1b

    // ... the histories
    lea rsi, [rbp + COUNTERS]
    movzx ecx, byte ptr [rbx + CONTEXTS]
1:  mov rdi, [rsi]
    mov al, [rdi + 4]
    xor al, 1
    jns 2f
    and al, 63
    or al, 64
2:  add al, al
    or eax, r9d
    xor al, 1
    mov [rdi + 4], al
    add rsi, 24
    loop 1b

    shr r9d, 1
    adc r11b, r11b
    jnc next_bit

    // end
    lea rsi, [rbp + BYTE_SLOTS]
    mov cl, [rbx + CONTEXTS] // rcx was 0
1:  lodsq
    mov [rax + 5], r11b
    loop 1b
    mov [r13], r11b
    mov [r12], r11b
    cmp [rbp + TYPE], ecx
    jne 1f
    movzx ecx, r11b
    call parse
    mov [rbp + LEFT], eax
1:  inc r12
    inc r13
    inc dword ptr [rbp + POSITION]
    mov eax, [rbp + POSITION]
    cmp eax, [rbx + SIZE]
    jb next_byte
    ret

// Operands of mix and train: ecx floats at rsi, and the weights at rdx.
point_to_inputs:
    lea rsi, [rbp + INPUTS]
    movzx ecx, byte ptr [rbx + CONTEXTS]
    lea ecx, [rcx + rcx * 2]
    ret
point_to_results:
    lea rdx, [rbp + FINAL_WEIGHTS]
    mov rsi, rbp // RESULTS
    push 8
    pop rcx
    ret

// xmm0 = sum of weights at rdx times inputs at rsi, ecx of them, limited to -11 .. 11.
mix:
    xorps xmm0, xmm0
1:  movaps xmm1, [rdx + rcx * 4 - 16]
    mulps xmm1, [rsi + rcx * 4 - 16]
    addps xmm0, xmm1
    sub ecx, 4
    jne 1b
    movaps xmm1, xmm0
    shufps xmm1, xmm1, 0xb1
    addps xmm0, xmm1
    movhlps xmm1, xmm0
    addss xmm0, xmm1
    minss xmm0, [rbx + MOST]
    maxss xmm0, [rbx + LEAST]
    ret

// Adds inputs at rsi, ecx of them, times xmm1 to the weights at rdx.
train:
    shufps xmm1, xmm1, 0
1:  movaps xmm0, [rsi + rcx * 4 - 16]
    mulps xmm0, xmm1
    addps xmm0, [rdx + rcx * 4 - 16]
    movaps [rdx + rcx * 4 - 16], xmm0
    sub ecx, 4
    jne 1b
    ret

squash:
    cvttss2si eax, xmm0
    add eax, 0x3f800000
    movd xmm0, eax
    movaps xmm1, xmm0
    addss xmm1, [rbx + ONE]
    divss xmm0, xmm1
    ret

// ---------------------------------------------------------------------------------------------------------
// Parser::step with the byte in ecx, and what run does with its result. What is left is eax, in and out.
parse:
    mov eax, [rbp + SO_FAR]
    mov edx, ecx
    call mix_in
    mov [rbp + SO_FAR], eax
    mov eax, [rbp + LEFT]
    mov dl, [rbp + PHASE]
    sub dl, 1
    jb at_start
    je at_vex
    sub dl, 2
    jb at_modrm
    je at_sib

    // In a displacement or an operand
    dec eax
    jne return
    cmp [rbp + RELATIVE], al
    je behind
    mov [rbp + RELATIVE], al
    mov eax, [r12 - 3]
    bswap eax
    sub eax, [rbp + POSITION]
    sub eax, [rbp + IMMEDIATE]
    dec eax
    mov [r12 - 3], eax
    xor eax, eax

behind: // ... an opcode, an operand, or a byte of one
    test eax, eax
    jne return
    or eax, [rbp + IMMEDIATE]
    je ends
    and dword ptr [rbp + IMMEDIATE], 0
    mov byte ptr [rbp + PHASE], 5
return:
    ret

ends:
    mov eax, [rbp + MODRM]
    mov [rbp + MODRM1], eax
    mov rax, [rbp + OPCODE1]
    mov [rbp + OPCODE2], rax
    mov eax, [rbp + OPCODE]
    mov [rbp + OPCODE1], eax
    mov eax, [rbp + SO_FAR]
    mov [rbp + INSTRUCTION1], eax
    lea rdi, [rbp + OPCODE]
    xor eax, eax
    stosq // opcode, modrm
    stosq // mode, so far
    stosq // phase, left
    stosq // wide, immediate
    ret

at_sib:
    inc byte ptr [rbp + PHASE]
    cmp byte ptr [rbp + MODRM], 0x40
    jae behind
    and cl, 7
    cmp cl, 5
    jne behind
    mov al, 4
    ret

at_modrm:
    mov [rbp + MODRM], ecx
    mov edx, ecx
    and dl, 0xc7
    mov [rbp + MODE], edx
    mov eax, [rbp + OPCODE]
    and al, 0xfe
    cmp ax, 0xf6
    jne 1f
    test cl, 0x30
    je 1f
    and dword ptr [rbp + IMMEDIATE], 0
1:  mov byte ptr [rbp + PHASE], 4
    push 4
    pop rax
    cmp dl, 5
    jne 1f
    mov [rbp + RELATIVE], al
    ret
1:  mov eax, ecx
    shr eax, 6
    cmp al, 3
    je 2f
    mul al
    and cl, 7
    cmp cl, 4
    jne behind
    dec byte ptr [rbp + PHASE]
    ret
2:  xor eax, eax
    jmp behind

at_vex:
    cmp al, 2
    jne 1f
    mov dl, cl
    and dl, 3
    mov [rbp + MAP], dl
1:  dec eax
    jne return
    mov [rbp + PHASE], al
    and ecx, 7
    shl ecx, 16
    mov [rbp + OPCODE], ecx
    mov al, [rbp + MAP]
    shl al, 2
    or al, 2
    ret

at_start:
    cmp al, 4
    jae mapped
    lea edx, [rcx - 0x40]
    cmp dl, 16
    jae 1f
    and ecx, 8
    mov [rbp + WIDE], ecx
    or al, 1
    ret
1:  mov edx, ecx
    and dl, 0xfe
    cmp cl, 0x66
    je 1f
    cmp dl, 0xf2
    jne 2f
1:  shl ecx, 16
    or [rbp + OPCODE], ecx
    ret
2:  cmp cl, 0x0f
    jne 3f
    or al, 4
    ret
3:  cmp dl, 0xc4
    jne at_opcode
    inc byte ptr [rbp + PHASE]
    mov byte ptr [rbp + MAP], 1
    mov al, 0xc6
    sub al, cl
    ret
mapped:
    cmp al, 6
    jae at_opcode
    mov dl, cl
    and dl, 0xfd
    cmp dl, 0x38
    jne at_opcode
    lea eax, [rax + rcx * 2 - 0x6c]
    ret

at_opcode:
    shr al, 2
    mov ah, al
    mov al, cl
    or [rbp + OPCODE], eax
    cmp eax, 0x40
    jae 1f
    and al, 7 // eight arithmetic operations go on alike
1:  movzx edx, byte ptr [rbp + rax + OPCODES]
    mov eax, edx
    shr eax, 1
    cmp dl, 6
    sete [rbp + RELATIVE]
    test dl, 4
    je 1f
    mov al, 4
    cmp dl, 6
    je 1f
    cmp byte ptr [rbp + OPCODE + 2], 0x66
    jne 2f
    mov al, 2
2:  cmp dl, 4
    jne 1f
    cmp byte ptr [rbp + WIDE], 0
    je 1f
    cmp cl, 0xb8
    jb 1f
    mov al, 8
1:  mov [rbp + IMMEDIATE], eax
    xor eax, eax
    test dl, 1
    je behind
    mov byte ptr [rbp + PHASE], 2
    ret

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
