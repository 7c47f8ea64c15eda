// The packed file of a program of any kind. The stub loads the program as the kernel would have loaded it.
//
// THE FILE is an executable (ELF, x86-64) of the program's own type, ET_EXEC or ET_DYN:
//
//     LoaderFront      184 bytes: ELF header, two program headers, the beginning of a third
//     stub             stub_loader.S, the same in every file
//     payload section  as in format.h
//
// It has no interpreter, so the kernel starts it directly.
//
// IN MEMORY the file has two segments, which stay where the kernel maps them. The first segment is the
// program: PayloadHeader::readOnly bytes, RW, from the program's own address PayloadHeader::image on; for
// ET_DYN the kernel adds an offset. It has one byte from the file, which decoding overwrites, because the
// kernel does not map a first segment that has no bytes in the file. The second segment is the file, R-X,
// right after the first, so the heap begins after both.
//
// THE PAYLOAD decodes to the program's segments as they are in memory. The first one must begin with the
// program's own ELF header; its program headers may be in any segment. The stub gets protections, interpreter
// and entry from these headers alone. Other fields of PayloadHeader are 0, and nothing is early.
//
// START. The stub checks the file and decodes as in format.h. Then it gives each segment its protection. The
// gaps between segments stay RW. If the program names an interpreter, the stub reads it into new memory. In
// the auxiliary vector, AT_PHDR, AT_PHNUM, AT_ENTRY and AT_BASE get the values of the program and the
// interpreter. The stub jumps to the interpreter, or to the program if it names none, with the stack as the
// kernel made it. ld.so, or the start code of a static program, does relocations, libraries, thread-local
// storage and constructors as always. The file stays mapped.
//
// ERRORS are as in format.h, but each line begins with the name by which the program was called. One more
// error is for an interpreter that cannot be loaded. It ends with errno in two digits: 80 if that is not a
// whole ELF file.
#pragma once

#include "packer/stub/format.h"

namespace pack {

// The kernel reads only type and flags of the last program header, GNU_STACK. The stub takes the place of the
// header's other fields.
struct LoaderFront {
    Elf64_Ehdr header;
    Elf64_Phdr program, file;
    uint32_t stackType, stackFlags;
};
static_assert(sizeof(LoaderFront) == 184);

} // namespace pack
