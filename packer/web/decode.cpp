// The page's decoder: the packer's model, compiled to WebAssembly.
#include "packer/model/decoder.h"
#include "packer/web/wasm_tracker.h"

using namespace pack;

#define EXPORT(name) extern "C" __attribute__((export_name(#name), used))

extern "C" unsigned char __heap_base;
extern "C" void *memset(void *to, int value, size_t n) { return __builtin_memset(to, value, n); }
extern "C" void *memcpy(void *__restrict to, const void *__restrict from, size_t n) {
    return __builtin_memcpy(to, from, n);
}

// Reports how many bytes are decoded.
extern "C" __attribute__((import_module("e"), import_name("p"))) void progress(uint32_t bytes);

namespace {

struct Reporting : web::WasmTracker {
    void begin(uint32_t i) {
        if (i % 4096 == 0) progress(i);
        WasmTracker::begin(i);
    }
};

// Layout, ModelParameters and payload follow the decoder's own data, then the decoded bytes and the model
unsigned char *payload() { return (unsigned char *)(((uintptr_t)&__heap_base + 63) & ~63ul); }
constexpr uint32_t kMostPayload = 1 << 17, kMostDecoded = 1 << 20;

} // namespace

EXPORT(i) unsigned char *input() { return payload(); }
EXPORT(d) unsigned char *decode() {
    const Layout &layout = *(const Layout *)payload();
    const ModelParameters &parameters = *(const ModelParameters *)(&layout + 1);
    unsigned char *image = payload() + kMostPayload, *model = image + kMostDecoded;
    Decoder decoder = {(const uint8_t *)(&parameters + 1)};
    codeImage<Reporting>(decoder, layout, parameters, model, image);
    return image;
}
