// Part of the stubs for Linux, as macros.

// Checks the file, which begins at rdi; goes to get_memory, or to damaged. A truncated file lacks pages, which must not
// be touched: access() returns whether a page is there.
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

// rax = esi bytes of zeros to read and write, at any place; the sign is set if there are none.
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

// The esi bytes at rax, just mapped, get large pages, if the system has them: a sixth of the time to decode.
.macro large_pages
    xchg rdi, rax
    push 14 // the advice
    pop rdx
    push 28 // madvise
    pop rax
    syscall
.endm
