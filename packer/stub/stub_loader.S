// The stub of programs of any kind: it checks the file, decodes the program, and loads and starts it as the kernel
// would have done. Baseline x86-64, position-independent, no library. loader_format.h describes its input, its actions
// and its results; the decoder is the same as in stub.S. The kernel starts it directly, so rdx is 0 as for any static
// program.
//
// Registers: rbx points to the payload header, later to the program's entry; r12 to the program in memory; xmm15 is the
// stack as the kernel made it, which the decoder does not change.

#define NOTHING_IS_EARLY
#include "stub_memory.S"
#include "stub_linux.S"

.section .stub, "ax"
start:
    movq xmm15, rsp
    push rdx // 0: the errors below have no second text
    lea rbx, [rip + payload_header]

    lea rdi, [rip + start - sizeof_LoaderFront]
    check_file
damaged:
    call refuse
    .asciz ": damaged: copy it again\n"
no_memory:
    call refuse
    .asciz ": not enough free memory\n"
refuse: // prints the program's name, the text after the call, and the text whose address is on the stack, or 0 for none
    movq rax, xmm15
    mov rsi, [rax + 8]
    call print
    pop rsi
    call print
    pop rsi
    call print
    SET_SMALL(rax, 60) // exit
    dec edi // 1
    syscall
print: // writes the string at rsi to standard error; 0: nothing, since a program may have no name
    or edx, -1
    test rsi, rsi
    je 2f
1:  inc edx
    cmp byte ptr [rsi + rdx], 0
    jne 1b
    SET_SMALL(rax, 1) // write
    SET_SMALL(rdi, 2)
    syscall
2:  ret

get_memory:
    mov esi, [rbx + header_memory]
    call map
    js no_memory
    push rax // for munmap
    lea rbp, [rax - FIELDS]
    large_pages

    // The program's memory ends where the file begins
    lea r12, [rip + start - sizeof_LoaderFront]
    mov eax, [rbx + header_readOnly]
    sub r12, rax
    push r12
    call decode
    pop r12
    pop rdi
    mov esi, [rbx + header_memory]
    SYSTEM_CALL(11) // munmap

    // Give the program's segments their protections. They are decoded already, so no file is read
    mov r13, r12
    mov eax, [rbx + header_image]
    sub r13, rax // the offset that the kernel added to the program's addresses
    mov r14, r12
    or ebp, -1
    call load
    mov rbx, r13
    add rbx, [r12 + e_entry] // the program's entry
    mov r9, rbx              // the address to jump to
    xor r10d, r10d           // the interpreter's base
    test r15, r15
    je give_vector

    // Map the interpreter, whose headers are in its first page
    lea rsi, [r13 + r15]
    SET_SMALL(rdi, -100) // AT_FDCWD
    mov eax, 257 // openat, because ld.so uses it too; some sandboxes do not allow open
    cdq
    syscall
    test eax, eax
    js no_interpreter
    mov ebp, eax
    xchg edi, eax
    mov dh, kPage / 256
    sub rsp, rdx
    mov r14, rsp
    push rsp
    pop rsi
    xor eax, eax // read
    syscall
    cmp eax, edx
    je 1f
no_interpreter: // eax = an error; or the number of bytes read, if the interpreter is incomplete
    neg eax
    jg 2f
    SET_SMALL(rax, 80) // ELIBBAD, the kernel's error for an incomplete interpreter
2:  mov cl, 10
    div cl
    add eax, 0xa3030 // "NN\n"
    push rax
    push rsp
    call refuse
    .asciz ": no interpreter: errno "
1:  cmp dword ptr [r14], 0x464c457f // the signature of ELF
    jne no_interpreter
    // Find the size, the end of the last segment: segments are in order of address
    call headers
1:  cmp dword ptr [rdi + p_type], PT_LOAD
    jne 2f
    mov rsi, [rdi + p_vaddr]
    add rsi, [rdi + p_memsz]
2:  add rdi, sizeof_Elf64_Phdr
    loop 1b
    call map
    js no_interpreter
    mov r13, rax
    call load
    mov edi, ebp
    SYSTEM_CALL(3) // close
    mov r10, r13
    mov r9, r13
    add r9, [r14 + e_entry]

// Makes the auxiliary vector, which follows the arguments and the environment, describe the program, not this file.
give_vector:
    mov r14, r12
    call headers
    movq rsp, xmm15
    pop rax
    push rax
    lea rsi, [rsp + rax * 8 + 16]
1:  lodsq
    test rax, rax
    jne 1b
2:  lodsq
    cmp eax, AT_PHDR
    cmove rdx, rdi
    je 3f
    cmp eax, AT_PHNUM
    cmove rdx, rcx
    je 3f
    cmp eax, AT_BASE
    cmove rdx, r10
    je 3f
    cmp eax, AT_ENTRY
    cmove rdx, rbx
    jne 4f
3:  mov [rsi], rdx
4:  add rsi, 8
    test eax, eax
    jne 2b
    cdq // there is no function to call at exit
    jmp r9

map:
    xor edi, edi
    map_memory
    ret

// rdi = address of the program headers of the ELF file at r14, ecx = their number.
headers:
    mov rdi, r14
    add rdi, [r14 + e_phoff]
    movzx ecx, word ptr [r14 + e_phnum]
    ret

// Loads the segments of the ELF file at r14, at their addresses plus r13: reads each from the file ebp, unless that is
// -1, and gives it its protection. r15 = address of the interpreter's name, without r13; or 0.
load:
    call headers
    xor r15d, r15d
load_next:
    push rcx
    push rdi
    cmp dword ptr [rdi + p_type], PT_INTERP
    cmove r15, [rdi + p_vaddr]
    cmp dword ptr [rdi + p_type], PT_LOAD
    jne 2f
    mov rsi, [rdi + p_vaddr]
    add rsi, r13
    mov r8, rdi
    mov r9, rsi
    test ebp, ebp
    js 1f
    mov rdx, [r8 + p_filesz]
    mov r10, [r8 + p_offset]
    mov edi, ebp
    SYSTEM_CALL(17) // pread64
    cmp rax, [r8 + p_filesz]
    jne no_interpreter
1:  // The bits for mprotect are the bits of the flags in reverse order: look them up in the digits of a number
    mov ecx, [r8 + p_flags]
    shl ecx, 2
    mov edx, 0x73516240
    shr edx, cl
    and edx, 7
    mov rdi, r9
    mov rsi, [r8 + p_memsz]
    and di, -kPage
    add rsi, r9
    sub rsi, rdi
    SYSTEM_CALL(10) // mprotect
    test eax, eax
    js not_allowed
2:  pop rdi
    pop rcx
    add rdi, sizeof_Elf64_Phdr
    loop load_next
    ret
not_allowed: // by SELinux, or systemd's MemoryDenyWriteExecute
    push 0
    call refuse
    .asciz ": may not run packed\n"

#define STUB_DECODE stubDecodeLoader
#include "stub_rest.S"
