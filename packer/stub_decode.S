// Part of stub.S: decoder.h and model.h.

decode:
    // expandOpcodes(), then the weights, which follow in memory
    lea rdi, [rbp + OPCODES]
    lea rsi, [rip + runs]
    push runs_end - runs
    pop rdx
1:  lodsb
    mov ecx, eax
    and al, (1 << CLASS_BITS) - 1
    shr cl, CLASS_BITS
2:  stosb
    dec cl
    jne 2b
    dec edx
    jne 1b
    mov ecx, PHASES * SETS + ALL_ROWS * MOST_INPUTS
    mov eax, FIRST_WEIGHT_BITS
    rep stosd

    inc dword ptr [rbp + RANGE] // 1
    mov eax, [rbx + MEMORY]
    sub eax, [rbx + SIZE]
    lea r13, [rbp + rax + FIELDS]
    movzx eax, byte ptr [rbx + CONTEXTS]
    lea r14, [rbx + rax * (2 * MASK) + MASKS + 2 * MASK * (SETS - 1)]

    xor eax, eax
next_byte: // eax is the position
    test eax, EARLY_STEP - 1
    jne 1f
    cmp eax, [rbx + EARLY]
    jb 1f
    // The early part: (stack at the program's start, bytes done, bytes in all)
    mov esi, [rbx + EARLY]
    call protect
    lea rdi, [rsp + 48] // six were pushed since
    mov esi, [rbp + POSITION]
    mov edx, [rbx + SIZE]
    mov eax, [rbx + EARLY_ENTRY]
    call rax
1:
    // Fields
    lea rdi, [rbp + FIELDS]
    mov eax, [rbp + LEFT]
    shl eax, PHASE_BITS
    or eax, [rbp + PHASE]
    stosd
    push FIELD_BYTE5
    pop rcx
    mov rsi, r13
1:  dec rsi
    movzx eax, byte ptr [rsi]
    stosd
    loop 1b
    mov edx, [rbp + POSITION]
    mov eax, edx
    and eax, COLUMNS - 1
    stosd

    // begin
    lea rsi, [rbx + MASKS]
    mov cl, [rbx + CONTEXTS] // rcx was 0
    add ecx, SETS - 1
    sub edx, [rbx + CODE_BEGIN]
    cmp edx, [rbx + CODE_SIZE]
    sbb edi, edi
    inc edi // 1 in data
    mov [rbp + TYPE], edi
    je 1f
    lea rsi, [rsi + rcx * MASK]
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
    bsr ecx, r11d
    and cl, 3 // bits of the nibble
    mov edx, r11d
    shr edx, cl
    mov [rbp + NIBBLE], edx
    dec edx
    shl edx, cl
    mov eax, r11d
    sub eax, edx
    mov [rbp + STEP], eax
    movzx r10d, byte ptr [rbx + CONTEXTS]
    lea rsi, [rbp + HASHES]
    lea rdi, [rbp + COUNTERS]
    lea r9, [rbp + BYTE_SLOTS]
    imul eax, [rbp + PHASE], SHARED
    lea r15, [rbp + rax + HISTORIES]
find:
    lodsd
    mov edx, [rbp + NIBBLE]
    call mix_in
    mov edx, eax // check in its low half
    mov cl, [rbx + SLOT_SHIFT]
    shr eax, cl
    xor eax, [rbp + STEP]
    lea rax, [r8 + rax * SLOT]
    cmp [rax + SLOT_CHECK], dx
    je 2f
    mov rcx, rax
    xor cl, SLOT * NIBBLE_SLOTS
    cmp [rcx + SLOT_CHECK], dx
    je 1f
    push rdx
    mov dl, [rax + SLOT_HISTORY]
    cmp [rcx + SLOT_HISTORY], dl
    pop rdx
    cmovae rcx, rax
    shl rdx, 8 * SLOT_CHECK
    mov [rcx], rdx // its other fields become 0
1:  mov rax, rcx
2:  stosq // a slot begins with its counter
    mov rcx, rax
    movzx eax, byte ptr [rcx + SLOT_HISTORY]
    lea rax, [r15 + rax * COUNTER]
    stosq
    cmp r11d, 1
    jne 3f
    mov [r9], rcx
3:  mov rcx, [r9]
    add r9, 8
    xor eax, eax
    mov ah, [rcx + SLOT_LAST_BYTE]
    mov al, r11b
    lea rax, [r15 + rax * COUNTER + AFTER_LAST]
    stosq
    add r15, PHASES * SHARED
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
    sar eax, SEEN_BITS
    mov edx, CERTAIN + 2
    sub edx, eax
    cvtsi2ss xmm1, edx
    add eax, CERTAIN + 2
    cvtsi2ss xmm0, eax
    psubd xmm0, xmm1
    cvtdq2ps xmm0, xmm0
    movd eax, xmm0
    stosd
    loop 1b

    // Mix
    push SETS
    pop r10
    mov eax, r11d
    mov ah, [rbp + PHASE]
1:  lea eax, [r10 + rax * SETS] // the eight sets' rows of one number are adjacent
    imul eax, eax, ROW
    lea rdx, [rbp + rax + WEIGHTS - ROW]
    mov [rbp + r10 * 8 + ROWS - 8], rdx
    call point_to_inputs
    call mix
    movss [rbp + r10 * 4 + RESULTS - 4], xmm0
    mov eax, [r9]
    add r9, 4
    shr eax, HASH_BITS - SET_ROW_BITS
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
    pop rsi
    lodsd
    mov edx, r11d
    call mix_in
    shr eax, HASH_BITS - CORRECTION_ROW_BITS - CORRECTION_BITS // rows of 32, of which this is the first
    and al, 0x100 - (1 << CORRECTION_BITS)
    mulss xmm5, [rbx + STEEPNESS]
    addss xmm5, [rbx + MIDDLE]
    cvttss2si edx, xmm5
    add eax, edx
    lea rax, [rbp + rax * COUNTER + CORRECTIONS]
    pop rdi
    mov [rdi], rax
    mulss xmm0, [rbx + SCALE]
    cvttss2si edx, xmm0
    cmp dword ptr [rax], 0
    jne 1f
    lea ecx, [rdx - HALF]
    shl ecx, SEEN_BITS
    mov cl, FIRST_TRUST
    mov [rax], ecx
1:  mov eax, [rax]
    sar eax, SEEN_BITS
    lea eax, [rax + rdx + HALF]
    shr eax, PROBABILITY_BITS + 1 - SHARE_BITS
    or al, 1

    // Decoder::bit
1:  cmp byte ptr [rbp + RANGE + RANGE_BITS / 8], 0
    jne 2f
    shl dword ptr [rbp + RANGE], 8
    shl dword ptr [rbp + CODE], 8
    mov cl, [r14]
    inc r14
    mov [rbp + CODE], cl
    jmp 1b
2:  mov edx, [rbp + RANGE]
    imul rax, rdx
    shr rax, SHARE_BITS
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
    push SETS
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

    // ... the counters, including the correction's
    lea rsi, [rbp + COUNTERS]
    lea r10d, [r9 - 1]
    xor r10d, CERTAIN // or its complement
    movzx ecx, byte ptr [rbx + CONTEXTS]
    lea r8d, [rcx + rcx * (CONTEXT_INPUTS - 1) + 1]
    movups xmm2, [rbx + SETTLED]
1:  lodsq
    movzx ecx, byte ptr [rax]
    cvtsi2ss xmm1, ecx
    addss xmm1, xmm2
    pshufd xmm2, xmm2, 0b001001 // rotate to the next counter's
    mov edx, [rax]
    sar edx, SEEN_BITS
    mov edi, r10d
    sub edi, edx
    cvtsi2ss xmm0, edi
    divss xmm0, xmm1
    cvttss2si edi, xmm0
    add edx, edi
    shl edx, SEEN_BITS
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
    mov al, [rdi + SLOT_HISTORY]
    xor al, 1
    jns 2f
    and al, HISTORY_FULL / 2 - 1
    or al, HISTORY_FULL / 2
2:  add al, al
    or eax, r9d
    xor al, 1
    mov [rdi + SLOT_HISTORY], al
    add rsi, 8 * CONTEXT_INPUTS
    loop 1b

    shr r9d, 1
    adc r11b, r11b
    jnc next_bit

    // end
    lea rsi, [rbp + BYTE_SLOTS]
    mov cl, [rbx + CONTEXTS] // rcx was 0
1:  lodsq
    mov [rax + SLOT_LAST_BYTE], r11b
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

// Operands of mix and train: ecx floats at rsi; the weights at rdx.
point_to_inputs:
    lea rsi, [rbp + INPUTS]
    movzx ecx, byte ptr [rbx + CONTEXTS]
    lea ecx, [rcx + rcx * (CONTEXT_INPUTS - 1)]
    ret
point_to_results:
    imul edx, [rbp + PHASE], 4 * SETS
    lea rdx, [rbp + rdx + FINAL_WEIGHTS]
    mov rsi, rbp // RESULTS
    push SETS
    pop rcx
    ret

// xmm0 = sum of weights at rdx times inputs at rsi, ecx of them, limited to kMostSum.
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
    movss xmm1, [rbx + ONE]
    cvttps2dq xmm0, xmm0
    paddd xmm0, xmm1
    addss xmm1, xmm0
    divss xmm0, xmm1
    ret
