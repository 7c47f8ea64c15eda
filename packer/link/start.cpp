#include "packer/link/start.h"

#include <algorithm>

namespace pack::linking {

namespace {

// __dso_handle, which crtbegin.o would define. Destructors are registered under its address, functions of
// atexit() under its value; exit() calls both.
constexpr char kEnd[] = R"(
.globl __dso_handle
.hidden __dso_handle
.bss
.balign 8
__dso_handle: .skip 8
.section .note.GNU-stack, "", @progbits
)";

// ld.so and the packer's stub leave rsp as the kernel made it: aligned to 16, argc on top. rdx is ld.so's
// function for exit. END is __libc_start_main.
constexpr char kCallWhole[] = R"(
    mov %rdx, %r9
    mov (%rsp), %esi
    lea 8(%rsp), %rdx
    mov $MAIN, %edi
    xor %ecx, %ecx
    xor %r8d, %r8d
    push %rsp
    push %rsp
    call *END(%rip)
)";
// ... END is exit().
constexpr char kCallMain[] = R"(
    pop %rdi
    mov %rsp, %rsi
    push %rax
    lea 8(%rsi, %rdi, 8), %rdx
    call MAIN
    xchg %eax, %edi
    call *END(%rip)
)";

// Looks up the names, which follow each other. A name that dlsym() does not find is a library's. edi:
// RTLD_DEFAULT, esi: RTLD_LAZY | RTLD_GLOBAL, as ld.so opens libraries.
constexpr char kLookup[] = R"(
    mov $names, %ebx
    mov $slots, %ebp
1:  mov %ebx, %esi
    xor %edi, %edi
    call *DLSYM@GOTPCREL(%rip)
    test %rax, %rax
    jnz 2f
    mov $0x101, %esi
    mov %ebx, %edi
    call *DLOPEN@GOTPCREL(%rip)
    test %rax, %rax
    jz missing
2:  mov %rax, (%rbp)
    add $8, %ebp
3:  inc %ebx
    cmpb $0, -1(%rbx)
    jne 3b
    cmpb $0, (%rbx)
    jne 1b
)";

// Prints the missing name as a line on standard error, by write(), and ends by exit_group().
constexpr char kMissing[] = R"(
missing:
    mov %ebx, %esi
    xor %edx, %edx
1:  inc %edx
    cmpb $0, (%rsi, %rdx)
    jne 1b
    movb $10, (%rsi, %rdx)
    inc %edx
    push $2
    pop %rdi
    push $1
    pop %rax
    syscall
    push $127
    pop %rdi
    mov $231, %eax
    syscall
)";

// Runs constructors and main(). Destructors are registered first, to run last. ATEXIT is __cxa_atexit.
constexpr char kRun[] = R"(
run:
    push %rbx
    push %rsi
    push %rdx
    push %rdi
    push %rdi
)",
               kRegister[] = R"(
    mov $finish, %edi
    xor %esi, %esi
    xor %edx, %edx
    call *ATEXIT(%rip)
)",
               kConstruct[] = R"(
    mov $__init_array_start, %ebx
1:  mov (%rsp), %rdi
    mov 16(%rsp), %rdx
    mov 24(%rsp), %rsi
    call *(%rbx)
    add $8, %ebx
    cmp $__init_array_end, %ebx
    jne 1b
)",
               kRunEnd[] = R"(
    pop %rdi
    pop %rdi
    pop %rdx
    pop %rsi
    pop %rbx
    jmp main
)",
               kFinish[] = R"(
finish:
    push %rbx
    mov $__fini_array_end, %ebx
1:  sub $8, %ebx
    call *(%rbx)
    cmp $__fini_array_start, %ebx
    jne 1b
    pop %rbx
    ret
)";

// Replaces a name in capitals by a value.
std::string with(std::string text, const std::string &name, const std::string &value) {
    for (size_t at; (at = text.find(name)) != text.npos;) text.replace(at, name.size(), value);
    return text;
}

} // namespace

std::string startDynamic(bool whole) {
    std::string end = whole ? "__libc_start_main@GOTPCREL" : "exit@GOTPCREL";
    return ".text\n.globl _start\n_start:\n" +
           with(with(whole ? kCallWhole : kCallMain, "MAIN", "main"), "END", end) + kEnd;
}

std::string startImports(const Plan &plan) {
    std::vector<std::string> names = plan.libraries; // to look up, each into a slot
    for (const Import &import : plan.imports) names.push_back(import.name);
    auto slotOf = [&](const std::string &name) {
        size_t i = (size_t)(std::find(names.begin(), names.end(), name) - names.begin());
        if (i == names.size()) names.push_back(name);
        return "slots+" + std::to_string(8 * i);
    };
    std::string real[] = {"dlopen", "dlsym"}; // these two themselves, if the program imports them
    std::string code, data, copies;
    for (const Import &import : plan.imports) {
        std::string label = import.name, slot = slotOf(label), size = std::to_string(import.size);
        for (std::string &name : real)
            if (name == label) {
                // By --wrap the program's calls go to this name
                label = "__wrap_" + name;
                name = "__real_" + name;
            }
        code += ".globl " + label + "\n";
        if (import.form == Import::kSlot) code += label + " = " + slot + "\n";
        if (import.form == Import::kJump) code += label + ": jmp *" + slot + "(%rip)\n";
        if (import.form != Import::kCopy) continue;
        data += ".balign 16\n" + label + ": .skip " + size + "\n";
        copies += "    mov " + slot + "(%rip), %rsi\n    mov $" + label + ", %edi\n    mov $" + size +
                  ", %ecx\n    rep movsb\n";
    }
    std::string end = slotOf(plan.whole ? "__libc_start_main" : "exit");
    bool runs = plan.constructors || plan.destructors;
    std::string text = ".section .text.start, \"ax\", @progbits\n.globl _start\n_start:\n";
    if (plan.whole) text += "    mov %rdx, %r12\n";
    text += with(with(kLookup, "DLOPEN", real[0]), "DLSYM", real[1]) + copies;
    if (plan.whole) text += "    mov %r12, %rdx\n";
    text += with(with(plan.whole ? kCallWhole : kCallMain, "MAIN", runs ? "run" : "main"), "END", end);
    text += kMissing;
    if (runs) text += kRun;
    if (plan.destructors) text += with(kRegister, "ATEXIT", slotOf("__cxa_atexit"));
    if (plan.constructors) text += kConstruct;
    if (runs) text += kRunEnd;
    if (plan.destructors) text += kFinish;
    text += code + ".bss\n" + data + ".data\nnames:\n";
    for (const std::string &name : names) text += "    .asciz \"" + name + "\"\n";
    return text + "    .byte 0\n.bss\n.balign 8\nslots: .skip " + std::to_string(8 * names.size()) + "\n" +
           kEnd;
}

const char kImportsScript[] = R"(ENTRY(_start)
PHDRS {
    interpreter PT_INTERP;
    code PT_LOAD FLAGS(5);
    data PT_LOAD FLAGS(6);
    dynamic PT_DYNAMIC;
    stack PT_GNU_STACK FLAGS(6);
}
SECTIONS {
    . = 0x400000;
    .rodata : { *(.rodata .rodata.*) } :code
    .text : { KEEP(*(.text.start)) *(.text .text.*) } :code
    . = ALIGN(0x1000);
    .data : {
        __init_array_start = .;
        KEEP(*(.preinit_array))
        KEEP(*(SORT_BY_INIT_PRIORITY(.init_array.*)))
        KEEP(*(.init_array))
        __init_array_end = .;
        __fini_array_start = .;
        KEEP(*(SORT_BY_INIT_PRIORITY(.fini_array.*)))
        KEEP(*(.fini_array))
        __fini_array_end = .;
        *(.data .data.*)
    } :data
    .bss : { *(.bss .bss.*) *(COMMON) } :data
    /* pack reads these and zeroes them; zeros at the end take no space */
    .got : { *(.got) } :data
    .got.plt : { *(.got.plt) } :data
    .interp : { *(.interp) } :data :interpreter
    .hash : { *(.hash) } :data
    .dynsym : { *(.dynsym) } :data
    .dynstr : { *(.dynstr) } :data
    .rela.dyn : { *(.rela.*) } :data
    .dynamic : { *(.dynamic) } :data :dynamic
    /DISCARD/ : { *(.eh_frame) *(.comment) *(.note*) }
}
)";

} // namespace pack::linking
