// Part of the stubs for Linux, as macros.

#define SYSTEM_CALL(number) SET_SMALL(rax, number); syscall

// Checks the file, which begins at rdi; jumps to get_memory, or to damaged. A truncated file lacks pages, and reading
// one would be fatal: access() returns whether a page is there.
.macro check_file
    mov edx, [rbx + header_words]
    xor esi, esi
    xor ebp, ebp
1:  test di, kPage - 1
    jne 2f
    SYSTEM_CALL(21) // access
    cmp al, -14 // EFAULT
    je damaged
2:  add ebp, [rdi]
    imul ebp, ebp, kHash
    scasd
    dec edx
    jne 1b
    test ebp, ebp
    je get_memory
.endm

// rax = address of esi new bytes of zeros, readable and writable; the sign flag is set if there is no memory.
.macro map_memory
    SET_SMALL(rdx, 3) // read, write
    SET_SMALL(r10, 0x22) // private, anonymous
    xor r9d, r9d
    SYSTEM_CALL(9) // mmap
    test rax, rax
.endm

// Asks for large pages for the esi bytes at rax, just mapped. They save a sixth of the time to decode.
.macro large_pages
    xchg rdi, rax
    SET_SMALL(rdx, 14) // MADV_HUGEPAGE
    SYSTEM_CALL(28) // madvise
.endm
