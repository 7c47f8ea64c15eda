// The packed file of a program of any kind, which the stub loads as the kernel would have loaded the program.
//
// THE FILE is an executable (ELF, x86-64) of the program's own type, ET_EXEC or ET_DYN:
//
//     LoaderFront      184 bytes: ELF header, two program headers, the beginning of a third
//     stub             stub_loader.S, the same in every file
//     payload section  as in format.h
//
// It has no interpreter, so the kernel starts it directly.
//
// IN MEMORY it has two segments, and both the program and the file keep the places that the kernel gave them.
// The first is the program: PayloadHeader::readOnly bytes, RW, from the address PayloadHeader::image on,
// which is the program's own; for ET_DYN the kernel adds an offset. Of the file it has a single byte,
// which decoding overwrites, because the kernel chooses no place for a first segment without any. The second,
// R-X, is the file, right behind, so the heap begins behind both.
//
// THE PAYLOAD decodes to the program's segments as they lie in memory. The first one must hold the program's
// own ELF header and program headers. They are all that the stub needs: protections, interpreter, entry.
// Other fields of PayloadHeader are 0, and nothing is early.
//
// START. The stub checks the file and decodes as in format.h. Then it gives each segment its protection. What
// lies between segments stays RW. If the program names an interpreter, that is read into fresh memory. In the
// auxiliary vector AT_PHDR, AT_PHNUM, AT_ENTRY and AT_BASE become those of the program and the interpreter.
// The stub jumps to the interpreter, or to the program if it names none, with the stack as the kernel made
// it. ld.so, or the start code of a static program, does relocations, libraries, thread-local storage and
// constructors as always. The file stays mapped.
//
// ERRORS are as in format.h, after the name by which the program was called; one more is for the interpreter,
// with the error's number in two digits: errno of the call that failed, 80 if the file is no whole ELF file.
#pragma once

#include "packer/stub/format.h"

namespace pack {

// Of the last program header, GNU_STACK, the kernel reads type and flags alone: the stub takes the place of
// the rest.
struct LoaderFront {
    Elf64_Ehdr header;
    Elf64_Phdr program, file;
    uint32_t stackType, stackFlags;
};
static_assert(sizeof(LoaderFront) == 184);

} // namespace pack
