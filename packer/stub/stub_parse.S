// Part of stub.S: the parser of x86.h.

// X86Parser::step() with the byte in ecx, then X86Tracker::end() and codeImage(). eax is `left`, in and out.
parse:
    mov eax, [rbp + FIELD(kSoFar)]
    mov edx, ecx
    call mix_in
    mov [rbp + FIELD(kSoFar)], eax
    mov eax, [rbp + LEFT]
    mov dl, [rbp + PHASE]
    sub dl, kVex
    jb at_start
    je at_vex
    sub dl, kSibByte - kVex
    jb at_modrm
    je at_sib

    // In a displacement or an operand
    dec eax
    jne return
    mov dl, [rbp + RELATIVE]
    test dl, dl
    je after_part
    mov [rbp + RELATIVE], al
    mov edi, [rbp + POSITION]
    movsx eax, cl
    lea eax, [rax + rdi + 1]
    dec dl
    je 1f
    mov eax, [r12 - 3]
    bswap eax
    mov ecx, eax
    sub ecx, edi
    sub ecx, [rbp + IMMEDIATE]
    dec ecx
    mov [r12 - 3], ecx
1:  mov [rbp + FIELD(kTarget)], eax
    cmp eax, [rbx + header_size]
    jae 2f
    sub eax, edi
    cdqe
    or byte ptr [r13 + rax * sizeof_CodedByte + coded_marks], kMarkTarget
2:  xor eax, eax

after_part: // after an opcode, an operand, or a byte of an operand
    test eax, eax
    jne return
    or eax, [rbp + IMMEDIATE]
    je ends
    and dword ptr [rbp + IMMEDIATE], 0
    mov byte ptr [rbp + PHASE], kOperand
    cmp byte ptr [rbp + RELATIVE], 1
    sbb byte ptr [rbp + PHASE], -1 // kJump, if it is relative
return:
    ret

ends:
    or byte ptr [r13 + sizeof_CodedByte + coded_marks], kMarkBegin
    mov eax, [rbp + FIELD(kModrm)]
    and al, 0x38
    mov cl, [rbp + HIGH]
    and cl, 4
    or al, cl
    xchg [rbp + FIELD(kWritten1)], eax
    mov [rbp + FIELD(kWritten2)], eax
    mov rax, [rbp + FIELD(kOpcode1)]
    mov [rbp + FIELD(kOpcode2)], rax // and kOpcode3
    mov eax, [rbp + FIELD(kOpcode)]
    mov [rbp + FIELD(kOpcode1)], eax
    cmp eax, kReturn
    jne 1f
    inc dword ptr [rbp + FIELD(kFunction)]
1:  mov eax, [rbp + FIELD(kSoFar)]
    mov [rbp + FIELD(kInstruction1)], eax
    lea rdi, [rbp + FIELD(kOpcode)]
    xor eax, eax
    stosq // opcode, mode
    stosq // so far, modrm
    stosq // phase, left
    stosq // high, immediate
    ret

at_sib:
    inc byte ptr [rbp + PHASE] // kDisplacement
    cmp byte ptr [rbp + FIELD(kModrm)], 0x40
    jae after_part
    and cl, 7
    cmp cl, 5
    jne after_part
    mov al, 4
    ret

at_modrm:
    mov [rbp + FIELD(kModrm)], ecx
    mov edx, ecx
    and dl, 0xc7
    mov [rbp + FIELD(kMode)], edx
    mov eax, [rbp + FIELD(kOpcode)]
    and al, 0xfe
    cmp ax, 0xf6
    jne 1f
    test cl, 0x30
    je 1f
    and dword ptr [rbp + IMMEDIATE], 0
1:  mov byte ptr [rbp + PHASE], kDisplacement
    SET_SMALL(rax, 4)
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
    jne after_part
    dec byte ptr [rbp + PHASE] // kSibByte
    ret
2:  xor eax, eax
    jmp after_part

at_vex:
    cmp al, 2
    jne 1f
    mov dl, cl
    and dl, 3
    mov [rbp + MAP], dl
1:  cmp byte ptr [rbp + HIGH], 0
    jne 1f
    mov edx, ecx
    shr edx, 5
    mov [rbp + HIGH], edx
1:  dec eax
    jne return
    mov [rbp + PHASE], al // kStart
    and ecx, 7
    shl ecx, kPrefixShift
    mov [rbp + FIELD(kOpcode)], ecx
    mov al, [rbp + MAP]
    shl al, kMapShift
    or al, kSeenVex
    ret

at_start:
    cmp al, kSeenMap
    jae mapped
    lea edx, [rcx - 0x40]
    cmp dl, 16
    jae 1f
    and ecx, 15
    mov [rbp + HIGH], ecx
    or al, kSeenRex
    ret
1:  mov edx, ecx
    and dl, 0xfe
    cmp cl, 0x66
    je 1f
    cmp dl, 0xf2
    jne 2f
1:  shl ecx, kPrefixShift
    or [rbp + FIELD(kOpcode)], ecx
    ret
2:  cmp cl, 0x0f
    jne 3f
    or al, kSeenMap
    ret
3:  cmp dl, 0xc4
    jne at_opcode
    inc byte ptr [rbp + PHASE] // kVex
    mov byte ptr [rbp + MAP], 1
    mov al, 0xc6
    sub al, cl
    ret
mapped:
    cmp al, kSeenMap + kSeenVex
    jae at_opcode
    mov dl, cl
    and dl, 0xfd
    cmp dl, 0x38
    jne at_opcode
    lea eax, [rax + rcx * 2 + kSeenMap - 0x38 * 2]
    ret

at_opcode:
    shr al, kMapShift
    mov ah, al
    mov al, cl
    or [rbp + FIELD(kOpcode)], eax
    cmp eax, 0x40
    jae 1f
    and al, 7 // the eight arithmetic operations have the same form
1:  movzx edx, byte ptr [rbp + rax + OPCODES]
    mov eax, edx
    shr eax, 1
    test dl, kImmediate32
    je 1f
    mov al, 4
    cmp dl, kRelative32
    jb 3f
    je 2f
    mov al, 1
    dec edx // no ModRM byte
2:  mov [rbp + RELATIVE], al
    jmp 1f
3:  cmp byte ptr [rbp + FIELD(kOpcode) + kPrefixShift / 8], 0x66
    jne 2f
    mov al, 2
2:  cmp dl, kImmediate32
    jne 1f
    test byte ptr [rbp + HIGH], 8
    je 1f
    cmp cl, 0xb8
    jb 1f
    mov al, 8
1:  mov [rbp + IMMEDIATE], eax
    xor eax, eax
    test dl, kHasModrm
    je after_part
    mov byte ptr [rbp + PHASE], kModrmByte
    ret
