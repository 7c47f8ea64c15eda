#include "tools/radiosity/patches/patch_system.h"

#include <stdexcept>
#include <sys/mman.h>

namespace odraz::radiosity {

void PatchSystem::Unmap::operator()(void *memory) const { munmap(memory, bytes); }

PatchSystem::PatchSystem(size_t bytes) {
    void *block =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED)
        throw std::runtime_error("the system cannot reserve that much memory: lower --memory");
    memory = {block, Unmap{bytes}};
    arena = {(unsigned char *)block, bytes, 0};
    model = std::make_unique<Model>();
    scene = std::make_unique<Scene>();
}

} // namespace odraz::radiosity
