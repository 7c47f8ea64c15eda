// Part of stub.S: the decoder of decoder.h and the model of model.h.

decode:
    // Expand the opcodes, then initialise the weights, which follow in memory
    lea rdi, [rbp + OPCODES]
    lea rsi, [rip + runs]
    SET_SMALL(rdx, runs_end - runs)
1:  lodsb
    mov ecx, eax
    and al, (1 << kClassBits) - 1
    shr cl, kClassBits
2:  stosb
    dec cl
    jne 2b
    dec edx
    jne 1b
    mov ecx, kPhases * kSets + ALL_ROWS * ROW / 4
    mov eax, kFirstWeight
    rep stosd

    inc dword ptr [rbp + RANGE] // 1
    mov eax, [rbx + header_memory]
    sub eax, [rbx + header_size]
    sub eax, [rbx + header_size]
    lea r13, [rbp + rax + FIELDS - sizeof_CodedByte * kFuture]
    movzx eax, byte ptr [rbx + header_contexts]
    imul eax, eax, kCodeMask + kDataMask
    lea r14, [rbx + rax + sizeof_PayloadHeader + (kCodeMask + kDataMask) * (kSets - 1)]

    xor eax, eax
next_byte: // eax = offset of the byte in the image
#ifndef NOTHING_IS_EARLY
    test eax, kEarlyStep - 1
    jne 1f
    mov esi, [rbx + header_early]
    cmp eax, esi
    jb 1f
    // Call the early part: (stack at the program's start, bytes done, bytes in all)
    call protect
    lea rdi, [rsp + 48] // six values were pushed since then
    mov esi, [rbp + POSITION]
    mov edx, [rbx + header_size]
    mov eax, [rbx + header_earlyEntry]
    call rax
1:
#endif
    // Compute the fields
    lea rdi, [rbp + FIELDS]
    mov eax, [rbp + LEFT]
    shl eax, kPhaseBits
    or eax, [rbp + PHASE]
    stosd
    mov edx, [rbp + POSITION]
    mov eax, edx
    and eax, kColumns - 1
    stosd
    SET_SMALL(rcx, 1 + kByte1 - kByte5)
    lea rsi, [r13 - sizeof_CodedByte * (1 + kByte1 - kByte5)]
1:  lodsw
    movzx eax, al
    stosd
    loop 1b
    mov eax, ecx
1:  cmp byte ptr [r13 + rax * sizeof_CodedByte + coded_marks], cl
    js 2f
    inc eax
    cmp al, kFarMark
    jne 1b
2:  stosd

    // Find the possible targets that the byte selects
    xor eax, eax
    cmp byte ptr [rbp + LEFT], 1
    jne 2f
    mov cl, [rbp + RELATIVE]
    jrcxz 2f
    mov [rbp + FLIP], al
    loop 1f // four bytes
    mov byte ptr [rbp + FLIP], 0x80
    lea rax, [r13 + sizeof_CodedByte * (1 - 128)]
    jmp 2f
1:  mov ecx, [r12 - 3]
    bswap ecx
    mov cl, 0
    cmp ecx, [rbx + header_size]
    jae 2f
    sub ecx, edx
    movsxd rax, ecx
    lea rax, [r13 + rax * sizeof_CodedByte]
2:  mov [rbp + BLOCK], rax

    // Compute the hashes of the byte: beginByte()
    lea rsi, [rbx + sizeof_PayloadHeader]
    movzx ecx, byte ptr [rbx + header_contexts]
    add ecx, kSets - 1
    sub edx, [rbx + header_codeBegin]
    cmp edx, [rbx + header_codeSize]
    sbb r8d, r8d
    inc r8d // 1 in data, 0 in code
    mov [rbp + TYPE], r8d
    je 1f
    lea rsi, [rsi + rcx * kCodeMask]
1:  lea rdi, [rbp + HASHES]
hash_next:
    xor eax, eax
    lodsb
    test r8d, r8d
    jne 1f
    mov ah, [rsi]
    inc rsi
    shl eax, kCodeShift
1:  xchg r9d, eax
    lea eax, [rcx + r8]
    mov edx, [rbp + FIELD(kParserState)]
1:  call mix_in
    bsf edx, r9d
    je 2f
    btr r9d, edx
    mov edx, [rbp + rdx * 4 + FIELD(kColumn)]
    jmp 1b
2:  stosd
    loop hash_next

    lea r8, [rbp + SLOTS]
    SET_SMALL(r11, 1)
    SET_SMALL(rax, kNibbleSlots)
next_bit: // eax = the step; kNibbleSlots or more: a nibble begins
    cmp al, kNibbleSlots
    jb 2f
    // Compute the nibble's hashes, and prefetch its slots
    movzx r10d, byte ptr [rbx + header_contexts]
    lea rdi, [rbp + HASHES]
1:  mov eax, [rdi]
    mov edx, r11d
    call mix_in
    stosd
    mov cl, [rbx + header_slotShift]
    shr eax, cl
    lea rax, [r8 + rax * sizeof_Slot]
    and ax, -WAYS_SIZE
    push WAYS_SIZE / 64
    pop rcx
3:  prefetcht0 [rax]
    add rax, 64
    loop 3b
    dec r10d
    jne 1b
    mov eax, r11d
    xor al, 16
    shl eax, AFTER_BITS
    mov [rbp + AFTER], eax
    SET_SMALL(rax, 1)
2:  mov [rbp + STEP], eax

    // Predict: find the counters
    movzx r10d, byte ptr [rbx + header_contexts]
    lea rsi, [rbp + HASHES]
    lea rdi, [rbp + COUNTERS]
    lea r9, [rbp + BYTE_SLOTS]
    imul eax, [rbp + PHASE], kPhaseCounters * sizeof_Counter
    lea r15, [rbp + rax + HISTORIES]
find:
    lodsd
    mov edx, eax // the low half is the check
    mov cl, [rbx + header_slotShift]
    shr eax, cl
    xor eax, [rbp + STEP]
    lea rax, [r8 + rax * sizeof_Slot]
    and ax, ~(WAYS_SIZE - sizeof_Slot * kNibbleSlots)
    push rsi
    mov rsi, rax
    mov ch, kWays
1:  cmp [rax + slot_check], dx
    je 2f
    mov cl, [rsi]
    cmp [rax], cl
    cmovb rsi, rax
    sub rax, -sizeof_Slot * kNibbleSlots
    dec ch
    jne 1b
    mov rax, rsi
    shl rdx, 8 * slot_check
    mov [rax], rdx // its other fields become 0
2:  pop rsi
    stosq // a slot begins with its counter
    mov rcx, rax
    movzx eax, byte ptr [rcx + slot_history]
    lea rax, [r15 + rax * sizeof_Counter]
    stosq
    cmp r11d, 1
    jne 3f
    mov [r9], rcx
3:  mov rcx, [r9]
    add r9, 8
    movzx eax, byte ptr [rcx + slot_lastByte]
    shl eax, AFTER_BITS - 8
    add eax, [rbp + AFTER]
    add rax, r15
    mov ecx, [rbp + STEP]
    lea rax, [rax + rcx * sizeof_Counter + kHistories * sizeof_Counter]
    stosq
    add r15, kSharedCounters * sizeof_Counter
    dec r10d
    jne find
    push rdi // address for the pointer to the correction
    mov r9, rsi // hashes of the selectors

    // Prefetch the row of corrections
    lodsd
    mov edx, r11d
    call mix_in
    shr eax, 32 - kCorrectionRowBits - kCorrectionBits // a row has 32 counters; eax = index of the first
    and al, 0x100 - (1 << kCorrectionBits)
    lea rax, [rbp + rax * sizeof_Counter + CORRECTIONS]
    prefetcht0 [rax]
    prefetcht0 [rax + 64]
    push rax

    // Compute the odds: the sum of the marks of the targets after a one, against the sum after a zero
    mov rdi, [rbp + BLOCK]
    xorps xmm0, xmm0
    test rdi, rdi
    je 3f
    mov edx, r11d
    bsr ecx, edx
    xor cl, 7
    shl edx, cl
    add edx, edx // its low byte is the first target after a zero
    SET_SMALL(rsi, 1)
    shl esi, cl // the number of targets after a zero, and after a one
    SET_SMALL(r15, 2)
1:  mov eax, esi
    mov ecx, esi
2:  movzx r10d, dl
    xor r10b, [rbp + FLIP]
    movzx r10d, byte ptr [rdi + r10 * sizeof_CodedByte + coded_marks]
    add eax, r10d
    inc edx
    loop 2b
    cvtsi2ss xmm1, eax
    psubd xmm1, xmm0
    movaps xmm0, xmm1
    dec r15d
    jne 1b
3:  pslld xmm0, kOddsShift
    cvtdq2ps xmm0, xmm0
    lea rdi, [rbp + INPUTS]
    movss [rdi], xmm0
    mov byte ptr [rdi + 7], kConstant >> 24 // its other bytes are 0

    // Compute the inputs ln(p / (1 - p)) and p - 1/2, for a context's three counters at once
    mov eax, kCertain + 2
    movd xmm3, eax
    pshufd xmm3, xmm3, 0
    movzx ecx, byte ptr [rbx + header_contexts]
    lea rsi, [rbp + COUNTERS]
1:  call counters
    psrad xmm0, kSeenBits
    pshufd xmm2, xmm0, 0b00111111 // the first counter to the fourth lane; the other lanes become 0
    movaps xmm1, xmm3
    psubd xmm1, xmm0
    paddd xmm0, xmm3
    cvtdq2ps xmm1, xmm1
    cvtdq2ps xmm0, xmm0
    psubd xmm0, xmm1
    pslld xmm2, kLinearShift
    paddd xmm0, xmm2
    cvtdq2ps xmm0, xmm0
    add rdi, 16
    movaps [rdi], xmm0
    loop 1b

    // Mix each set, then the results
    SET_SMALL(r10, kSets)
    mov eax, r11d
    mov ah, [rbp + PHASE]
1:  lea eax, [r10 + rax * kSets] // rows of the eight sets with the same number are adjacent
    imul eax, eax, ROW
    lea rdx, [rbp + rax + WEIGHTS - ROW]
    mov [rbp + r10 * 8 + ROWS - 8], rdx
    call point_to_inputs
    call mix
    movss [rbp + r10 * 4 + RESULTS - 4], xmm0
    mov eax, [r9]
    add r9, 4
    shr eax, 32 - kRowBits
    mov ecx, r10d
    or cl, 4
    mov edx, r11d
    shr edx, cl
    xor eax, edx
    dec r10d
    jne 1b
    call point_to_results
    call mix
    movaps xmm5, xmm0
    call squash
    movaps xmm4, xmm0 // mixed, until learn

    // Correct
    mulss xmm5, [rbx + STEEPNESS]
    addss xmm5, [rbx + MIDDLE]
    cvttss2si edx, xmm5
    pop rax
    lea rax, [rax + rdx * sizeof_Counter]
    pop rdi
    stosq // three equal pointers, as for a context's counters; adapting writes the first one last, so that one counts
    stosq
    stosq
    mulss xmm0, [rbx + SCALE]
    cvttss2si edx, xmm0
    mov ecx, [rax]
    test ecx, ecx
    jne 1f
    lea ecx, [rdx - kHalf]
    shl ecx, kSeenBits
    mov cl, kFirstTrust
    mov [rax], ecx
1:  sar ecx, kSeenBits
    lea eax, [rcx + rdx * 2 + kHalf]
    add eax, edx
    shr eax, kProbabilityBits + 2 - kShareBits
    or al, 1

    // Decoder::bit
1:  cmp byte ptr [rbp + RANGE + kRangeBits / 8], 0
    jne 2f
    shl dword ptr [rbp + RANGE], 8
    shl dword ptr [rbp + CODE], 8
    mov cl, [r14]
    inc r14
    mov [rbp + CODE], cl
    jmp 1b
2:  mov edx, [rbp + RANGE]
    imul rax, rdx
    shr rax, kShareBits
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

    // Learn: train the weights
    cvtsi2ss xmm3, r9d
    SET_SMALL(r10, kSets)
1:  movss xmm0, [rbp + r10 * 4 + RESULTS - 4]
    call squash
    movaps xmm1, xmm3
    subss xmm1, xmm0
    mov rdx, [rbp + r10 * 8 + ROWS - 8]
    movss xmm0, [rdx + USED]
    movss xmm2, [rbx + EARLY_USES]
    addss xmm2, xmm0
    movss xmm5, [rbx + EARLY_LEARNING]
    divss xmm5, xmm2
    addss xmm5, [rbx + LEARNING]
    mulss xmm1, xmm5
    addss xmm0, [rbx + ONE]
    movss [rdx + USED], xmm0
    call point_to_inputs
    call train
    dec r10d
    jne 1b
    movaps xmm1, xmm3
    subss xmm1, xmm4
    mulss xmm1, [rbx + FINAL_LEARNING]
    call point_to_results
    call train

    // Adapt the counters, a context's three at once, then the correction's counter
    lea eax, [r9 - 1]
    xor eax, kCertain // kCertain for a one, its complement for a zero
    movd xmm3, eax
    pshufd xmm3, xmm3, 0
    pcmpeqd xmm4, xmm4
    psrld xmm4, 31 // 1 in each lane
    movups xmm5, [rbx + SETTLED]
    mov cl, [rbx + header_contexts] // rcx was 0
    inc ecx
    lea rsi, [rbp + COUNTERS]
1:  call counters
    movaps xmm1, xmm0
    psrad xmm0, kSeenBits
    pslld xmm1, 32 - kSeenBits
    psrld xmm1, 32 - kSeenBits
    cvtdq2ps xmm2, xmm1
    addps xmm2, xmm5
    movaps xmm6, xmm3
    psubd xmm6, xmm0
    cvtdq2ps xmm6, xmm6
    divps xmm6, xmm2
    cvttps2dq xmm6, xmm6
    paddd xmm0, xmm6
    pslld xmm0, kSeenBits
    paddusb xmm1, xmm4 // counts one more bit seen, up to 255
    orps xmm0, xmm1
    mov rax, [rsi - 8]
    pshufd xmm1, xmm0, 2
    movd [rax], xmm1
    mov rax, [rsi - 16]
    pshufd xmm1, xmm0, 1
    movd [rax], xmm1
    mov rax, [rsi - 24]
    movd [rax], xmm0
    loop 1b

    // Update the histories
    lea rsi, [rbp + COUNTERS]
    mov cl, [rbx + header_contexts]
1:  mov rdi, [rsi]
    mov al, [rdi + slot_history]
    xor al, 1
    jns 2f
    and al, kHistoryFull / 2 - 1
    or al, kHistoryFull / 2
2:  add al, al
    or eax, r9d
    xor al, 1
    mov [rdi + slot_history], al
    add rsi, 8 * kContextCounters
    loop 1b

    mov eax, [rbp + STEP]
    lea eax, [r9 + rax * 2]
    shr r9d, 1
    adc r11b, r11b
    jnc next_bit

    // End the byte: endByte(), then parse it if it is code
    lea rsi, [rbp + BYTE_SLOTS]
    mov cl, [rbx + header_contexts] // rcx was 0
1:  lodsq
    mov [rax + slot_lastByte], r11b
    loop 1b
    mov [r13], r11b
    mov [r12], r11b
    cmp [rbp + TYPE], ecx
    jne 1f
    movzx ecx, r11b
    call parse
    mov [rbp + LEFT], eax
1:  inc r12
    add r13, sizeof_CodedByte
    inc dword ptr [rbp + POSITION]
    mov eax, [rbp + POSITION]
    cmp eax, [rbx + header_size]
    jb next_byte
    ret

// xmm0 = the three counters that the three pointers at rsi point to, and 0 in the fourth lane. Advances rsi.
counters:
    lodsq
    movd xmm0, [rax]
    lodsq
    movd xmm1, [rax]
    punpckldq xmm0, xmm1
    lodsq
    movd xmm1, [rax]
    punpcklqdq xmm0, xmm1
    ret

// Sets the operands of mix and train: ecx bytes of floats at rsi, the weights at rdx.
point_to_inputs:
    lea rsi, [rbp + INPUTS]
    movzx ecx, byte ptr [rbx + header_contexts]
    inc ecx
    shl ecx, 4
    ret
point_to_results:
    imul edx, [rbp + PHASE], 4 * kSets
    lea rdx, [rbp + rdx + FINAL_WEIGHTS]
    mov rsi, rbp // RESULTS
    SET_SMALL(rcx, 4 * kSets)
    ret

// xmm0 = sum of weights at rdx times inputs at rsi, limited to kMostSum.
mix:
    xorps xmm0, xmm0
1:  movaps xmm1, [rdx + rcx - 16]
    mulps xmm1, [rsi + rcx - 16]
    addps xmm0, xmm1
    sub ecx, 16
    jne 1b
    movaps xmm1, xmm0
    shufps xmm1, xmm1, 0xb1
    addps xmm0, xmm1
    movhlps xmm1, xmm0
    addss xmm0, xmm1
    minss xmm0, [rbx + MOST]
    maxss xmm0, [rbx + LEAST]
    ret

// Adds inputs at rsi times xmm1 to the weights at rdx.
train:
    shufps xmm1, xmm1, 0
1:  movaps xmm0, [rsi + rcx - 16]
    mulps xmm0, xmm1
    addps xmm0, [rdx + rcx - 16]
    movaps [rdx + rcx - 16], xmm0
    sub ecx, 16
    jne 1b
    ret

squash:
    movss xmm1, [rbx + ONE]
    cvttps2dq xmm0, xmm0
    paddd xmm0, xmm1
    addss xmm1, xmm0
    divss xmm0, xmm1
    ret
