// Part of the stubs for Linux, as macros.

// Checks the file, which begins at rdi; jumps to get_memory, or to damaged. A truncated file lacks pages, and reading
// one would be fatal: access() returns whether a page is there.
.macro check_file
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
.endm

// rax = address of esi new bytes of zeros, readable and writable; the sign flag is set if there is no memory.
.macro map_memory
    push 3 // read, write
    pop rdx
    push 0x22 // private, anonymous
    pop r10
    xor r9d, r9d
    push 9 // mmap
    pop rax
    syscall
    test rax, rax
.endm

// Asks for large pages for the esi bytes at rax, just mapped. They save a sixth of the time to decode.
.macro large_pages
    xchg rdi, rax
    push 14 // MADV_HUGEPAGE
    pop rdx
    push 28 // madvise
    pop rax
    syscall
.endm
