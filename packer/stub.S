// The code in front of every packed program: checks the file, decodes the program, starts it. Position-
// independent, baseline x86-64, no library.
//
// In assembler, because it is part of every packed file: 1.9 KB, where g++ -Os makes 3.7 KB of the same in C++.
// It does what decoder.h, model.h and x86.h say, whose names it uses; the packer runs both before it writes a
// file. What it finds, does and leaves is described in format.h. Numbers that are C++'s as well come from
// stub_numbers.h; other numbers are offsets in its own memory, the kernel's calls and x86 opcodes, as in x86.h.
//
// Registers while decoding: rbx parameters, rbp within the model's memory, r12 the next byte of the image, r13
// the same in the copy of coded bytes, r14 the payload; r11d the byte so far (bits), r8 the slots. Subroutines
// clobber what they like of the rest.

.intel_syntax noprefix

// --- What is agreed with C++ ---
#define STUB_NUMBER(name, value, meaning) .set name, value;
#include "stub_numbers.h"

// --- From rbx: Parameters; before them the constants at the end of this file ---
.set MOST, -44
.set LEAST, -40
.set ONE, -36
.set SETTLED, -32 // three
.set LEARNING, -20
.set FINAL_LEARNING, -16
.set STEEPNESS, -12
.set MIDDLE, -8
.set SCALE, -4

// --- The model's memory, from rbp, which points behind the first variables so that most offsets are one byte ---
.set FIELDS, -112
.set WHERE, FIELDS + 4 * FIELD_WHERE
.set TARGET, FIELDS + 4 * FIELD_TARGET
.set INSTRUCTION1, FIELDS + 4 * FIELD_INSTRUCTION1
.set OPCODE1, FIELDS + 4 * FIELD_OPCODE1
.set OPCODE2, FIELDS + 4 * FIELD_OPCODE2
.set MODRM1, FIELDS + 4 * FIELD_MODRM1
.set OPCODE, FIELDS + 4 * FIELD_OPCODE
.set MODRM, FIELDS + 4 * FIELD_MODRM
.set MODE, FIELDS + 4 * FIELD_MODE
.set SO_FAR, FIELDS + 4 * FIELD_SO_FAR
// The parser's state, in the order in which it is cleared, and the decoder's
.set PHASE, FIELDS + 4 * FIELD_COUNT
.set LEFT, PHASE + 4
.set WIDE, LEFT + 4
.set IMMEDIATE, WIDE + 4
.set RELATIVE, IMMEDIATE + 4
.set MAP, RELATIVE + 4
.set RANGE, MAP + 4
.set CODE, RANGE + 4
.set POSITION, CODE + 4
.set TYPE, POSITION + 4
.set NIBBLE, TYPE + 4
.set RESULTS, 0
.set STEP, RESULTS + 4 * SETS
.set ROWS, STEP + 4 // of the last set first, as the results
.set HASHES, ROWS + 8 * SETS
.set INPUTS, HASHES + 4 * (MOST_CONTEXTS + SETS - 1)
.set COUNTERS, INPUTS + 4 * MOST_INPUTS
.set BYTE_SLOTS, COUNTERS + 8 * (MOST_INPUTS + 2) // the correction's too, and alignment
.set OPCODES, BYTE_SLOTS + 8 * MOST_CONTEXTS
.set FINAL_WEIGHTS, OPCODES + OPCODE_CLASSES
.set WEIGHTS, FINAL_WEIGHTS + 4 * SETS * PHASES
.set ROW, 4 * MOST_INPUTS
.set ALL_ROWS, SETS << SET_ROW_BITS
.set CORRECTIONS, WEIGHTS + ALL_ROWS * ROW
.set HISTORIES, CORRECTIONS + (COUNTER << (CORRECTION_ROW_BITS + CORRECTION_BITS))
.set SLOTS_FROM, HISTORIES + MOST_CONTEXTS * PHASES * SHARED - FIELDS
.set SLOTS, SLOTS_FROM + 255 - (SLOTS_FROM + 255) % 256 + FIELDS // so that their neighbours are found by a bit
// The slots follow, then kPast zeros and the coded bytes

// --- What the code relies on beyond these names ---
#define EQUAL(a, b) .ifne (a) - (b); .error "these are not equal"; .endif
EQUAL(FIELD_WHERE, 0) // fields up to the column are written in a row
EQUAL(FIELD_BYTE1, 1)
EQUAL(FIELD_COLUMN, FIELD_BYTE5 + 1)
EQUAL(FIELD_OPCODE2, FIELD_OPCODE1 + 1) // two move on as one
EQUAL(FIELD_OPCODE3, FIELD_OPCODE1 + 2)
EQUAL(FIELD_MODRM, FIELD_OPCODE + 1) // what is cleared with the parser's state
EQUAL(FIELD_MODE, FIELD_OPCODE + 2)
EQUAL(FIELD_SO_FAR, FIELD_OPCODE + 3)
EQUAL(FIELD_COUNT, FIELD_OPCODE + 4)
EQUAL(PHASE_START, 0) // the order in which phases are told apart
EQUAL(PHASE_VEX, 1)
EQUAL(PHASE_MODRM, 2)
EQUAL(PHASE_SIB, 3)
EQUAL(PHASE_DISPLACEMENT, 4)
EQUAL(SLOT_COUNTER, 0) // a fresh slot is its check, shifted up
EQUAL(SLOT_CHECK, SLOT - 2)
EQUAL(COUNTER, 4) // seen: its lowest byte
EQUAL(SEEN_BITS, 8)
EQUAL(HISTORY_FULL, 128) // the sign of a byte
EQUAL((SLOTS - FIELDS) & (2 * SLOT * NIBBLE_SLOTS - 1), 0)
EQUAL((INPUTS | FINAL_WEIGHTS | WEIGHTS) & 15, 0) // vectors
EQUAL(NIBBLE + 4, RESULTS) // the variables end in front of it, and keep it aligned

.section .stub, "ax"
start:
    push rdx // ld.so's function for exit, which the program wants to see
    push rsi
    lea ebx, [rip + parameters]

    // Check the file. A page that it is too short for must not be touched: access() says which. Nothing is
    // believed that was not checked: where the file begins follows from where this is
    lea edi, [rip + start - FRONT]
    mov edx, [rbx + WORDS]
    xor esi, esi
    xor ebp, ebp
1:  test di, PAGE - 1
    jne 2f
    push 21 // access
    pop rax
    syscall
    cmp al, -14 // EFAULT
    je damaged
2:  add ebp, [rdi]
    imul ebp, ebp, HASH
    scasd
    dec edx
    jne 1b
    test ebp, ebp
    je get_memory
damaged: // the texts stand here, so that a file cut short still has them; all are 23 long
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

// Makes esi bytes of the image R-X. Where what was written may never run (SELinux, systemd's
// MemoryDenyWriteExecute), the kernel refuses.
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
    .ascii "use odraz-safe instead\n"
1:  ret

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
#include "opcodes.h"
runs_end:
    .long MOST_BITS // in the order of MOST .. SCALE
    .long MOST_BITS | 0x80000000 // the sign
    .long ONE_BITS
    .long SETTLED0_BITS
    .long SETTLED1_BITS
    .long SETTLED2_BITS
    .long LEARNING_BITS
    .long FINAL_LEARNING_BITS
    .long STEEPNESS_BITS
    .long MIDDLE_BITS
    .long SCALE_BITS
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
