#include "packer/link/start.h"

namespace pack::linking {

namespace {

constexpr char kNoStack[] = ".section .note.GNU-stack, \"\", @progbits\n";

// Destructors are registered for the object that has this address, and atexit() for the one with this value.
// It is a variable of crtbegin.o; exit() calls what is registered for any.
constexpr char kObject[] = ".globl __dso_handle\n"
                           ".hidden __dso_handle\n"
                           ".bss\n"
                           ".balign 8\n"
                           "__dso_handle: .skip 8\n";

// ld.so and the packer's stub leave rsp as the kernel made it: aligned to 16, argc on top. rdx is ld.so's
// function for exit.
std::string callWhole(const std::string &function, const std::string &main) {
    return "    mov %rdx, %r9\n"
           "    mov (%rsp), %esi\n"
           "    lea 8(%rsp), %rdx\n"
           "    mov $" +
           main +
           ", %edi\n"
           "    xor %ecx, %ecx\n"
           "    xor %r8d, %r8d\n"
           "    push %rsp\n"
           "    push %rsp\n"
           "    call *" +
           function + "(%rip)\n";
}
std::string callMain(const std::string &exit, const std::string &main) {
    return "    pop %rdi\n"
           "    mov %rsp, %rsi\n"
           "    push %rax\n"
           "    lea 8(%rsi, %rdi, 8), %rdx\n"
           "    call " +
           main +
           "\n"
           "    xchg %eax, %edi\n"
           "    call *" +
           exit + "(%rip)\n";
}

// Looks for the names, which follow each other; those of libraries are no functions' names.
std::string lookup(const std::string &open, const std::string &find) {
    return "    mov $names, %ebx\n"
           "    mov $slots, %ebp\n"
           "1:  mov %ebx, %esi\n"
           "    xor %edi, %edi\n" // RTLD_DEFAULT
           "    call *" +
           find +
           "@GOTPCREL(%rip)\n"
           "    test %rax, %rax\n"
           "    jnz 2f\n"
           "    mov $0x101, %esi\n" // RTLD_LAZY | RTLD_GLOBAL, as ld.so does
           "    mov %ebx, %edi\n"
           "    call *" +
           open +
           "@GOTPCREL(%rip)\n"
           "    test %rax, %rax\n"
           "    jz missing\n"
           "2:  mov %rax, (%rbp)\n"
           "    add $8, %ebp\n"
           "3:  inc %ebx\n"
           "    cmpb $0, -1(%rbx)\n"
           "    jne 3b\n"
           "    cmpb $0, (%rbx)\n"
           "    jne 1b\n";
}

// Names what is missing, in a line on standard error.
constexpr char kMissing[] = "missing:\n"
                            "    mov %ebx, %esi\n"
                            "    xor %edx, %edx\n"
                            "1:  inc %edx\n"
                            "    cmpb $0, (%rsi, %rdx)\n"
                            "    jne 1b\n"
                            "    movb $10, (%rsi, %rdx)\n"
                            "    inc %edx\n"
                            "    push $2\n"
                            "    pop %rdi\n"
                            "    push $1\n" // write
                            "    pop %rax\n"
                            "    syscall\n"
                            "    push $127\n"
                            "    pop %rdi\n"
                            "    mov $231, %eax\n" // exit_group
                            "    syscall\n";

// Constructors and main; destructors are registered first, to run last.
std::string runAll(const Plan &plan, const std::string &atExit) {
    std::string text = "run:\n"
                       "    push %rbx\n"
                       "    push %rsi\n"
                       "    push %rdx\n"
                       "    push %rdi\n"
                       "    push %rdi\n";
    if (plan.destructors)
        text += "    mov $finish, %edi\n"
                "    xor %esi, %esi\n"
                "    xor %edx, %edx\n"
                "    call *" +
                atExit + "(%rip)\n";
    if (plan.constructors)
        text += "    mov $__init_array_start, %ebx\n"
                "1:  mov (%rsp), %rdi\n"
                "    mov 16(%rsp), %rdx\n"
                "    mov 24(%rsp), %rsi\n"
                "    call *(%rbx)\n"
                "    add $8, %ebx\n"
                "    cmp $__init_array_end, %ebx\n"
                "    jne 1b\n";
    text += "    pop %rdi\n"
            "    pop %rdi\n"
            "    pop %rdx\n"
            "    pop %rsi\n"
            "    pop %rbx\n"
            "    jmp main\n";
    if (plan.destructors)
        text += "finish:\n"
                "    push %rbx\n"
                "    mov $__fini_array_end, %ebx\n"
                "1:  sub $8, %ebx\n"
                "    call *(%rbx)\n"
                "    cmp $__fini_array_start, %ebx\n"
                "    jne 1b\n"
                "    pop %rbx\n"
                "    ret\n";
    return text;
}

// The names to look for, libraries first, and where each one's slot is.
class Slots {
public:
    explicit Slots(const Plan &plan) {
        for (const std::string &library : plan.libraries) place(library);
        for (const Import &import : plan.imports) place(import.name);
    }
    // Takes a slot if the name has none yet.
    std::string place(const std::string &name) {
        size_t i = 0;
        while (i < names.size() && names[i] != name) ++i;
        if (i == names.size()) names.push_back(name);
        return "slots+" + std::to_string(8 * i);
    }
    std::string print() const {
        std::string text = ".data\nnames:\n";
        for (const std::string &name : names) text += "    .asciz \"" + name + "\"\n";
        return text + "    .byte 0\n.bss\n.balign 8\nslots: .skip " + std::to_string(8 * names.size()) + "\n";
    }

private:
    std::vector<std::string> names;
};

// The linker's --wrap gives this name to what the program calls dlopen or dlsym.
std::string labelOf(const std::string &name) {
    return name == "dlopen" || name == "dlsym" ? "__wrap_" + name : name;
}
bool imports(const Plan &plan, const std::string &name) {
    for (const Import &import : plan.imports)
        if (import.name == name) return true;
    return false;
}
std::string realName(const Plan &plan, const std::string &name) {
    return (imports(plan, name) ? "__real_" : "") + name;
}

std::string printCopies(const Plan &plan, Slots &slots) {
    std::string text;
    for (const Import &import : plan.imports)
        if (import.form == Import::kCopy)
            text += "    mov " + slots.place(import.name) + "(%rip), %rsi\n    mov $" + import.name +
                    ", %edi\n    mov $" + std::to_string(import.size) + ", %ecx\n    rep movsb\n";
    return text;
}
std::string printForms(const Plan &plan, Slots &slots) {
    std::string code, data;
    for (const Import &import : plan.imports) {
        std::string label = labelOf(import.name), slot = slots.place(import.name);
        code += ".globl " + label + "\n";
        if (import.form == Import::kSlot) code += label + " = " + slot + "\n";
        if (import.form == Import::kJump) code += label + ": jmp *" + slot + "(%rip)\n";
        if (import.form == Import::kCopy)
            data += ".balign 16\n" + label + ": .skip " + std::to_string(import.size) + "\n";
    }
    return code + ".bss\n" + data;
}

} // namespace

std::string startDynamic(bool whole) {
    return std::string(".text\n.globl _start\n_start:\n") +
           (whole ? callWhole("__libc_start_main@GOTPCREL", "main") : callMain("exit@GOTPCREL", "main")) +
           kObject + kNoStack;
}

std::string startImports(const Plan &plan) {
    Slots slots(plan);
    std::string end = slots.place(plan.whole ? "__libc_start_main" : "exit");
    std::string atExit = plan.destructors ? slots.place("__cxa_atexit") : "";
    bool runs = plan.constructors || plan.destructors;
    std::string main = runs ? "run" : "main";
    std::string text = ".section .text.start, \"ax\", @progbits\n.globl _start\n_start:\n";
    if (plan.whole) text += "    mov %rdx, %r12\n";
    text += lookup(realName(plan, "dlopen"), realName(plan, "dlsym")) + printCopies(plan, slots);
    if (plan.whole) text += "    mov %r12, %rdx\n";
    text += plan.whole ? callWhole(end, main) : callMain(end, main);
    text += kMissing;
    if (runs) text += runAll(plan, atExit);
    return text + printForms(plan, slots) + slots.print() + kObject + kNoStack;
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
    /* pack reads these and leaves zeros, which take no space at the end */
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
