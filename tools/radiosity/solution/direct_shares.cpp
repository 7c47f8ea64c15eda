#include "tools/radiosity/solution/direct_shares.h"

#include "tools/radiosity/solution/arrays.h"

#include <algorithm>

namespace odraz::radiosity {

void DirectShares::find(const std::function<std::vector<Rgb>(const std::vector<Rgb> &)> &gather) {
    float Rgb::*const channels[3] = {&Rgb::x, &Rgb::y, &Rgb::z};
    for (size_t first = 0; first < emitters.size(); first += 3) {
        std::vector<Rgb> colours((size_t)emitters.back() + 1);
        size_t count = std::min(emitters.size() - first, (size_t)3);
        for (size_t k = 0; k < count; ++k) colours[(size_t)emitters[first + k]].*channels[k] = 1;
        std::vector<Rgb> light = gather(colours);
        for (size_t k = 0; k < count; ++k) {
            std::vector<float> &share = shares.emplace_back();
            for (const Rgb &l : light) share.push_back(l.*channels[k]);
        }
    }
}

std::vector<Rgb> DirectShares::light(const std::vector<Rgb> &emits, size_t texels) const {
    std::vector<Rgb> all = outside;
    all.resize(texels);
    for (size_t i = 0; i < shares.size(); ++i) {
        const Rgb &e = emits[(size_t)emitters[i]];
        if (!(maxComponent(e) > 0)) continue;
        for (size_t t = 0; t < texels; ++t) all[t] += e * shares[i][t];
    }
    return all;
}

void DirectShares::save(std::string &to) const {
    put(to, std::vector<uint8_t>{seen}, emitters);
    for (const std::vector<float> &share : shares) put(to, share);
    put(to, outside);
}

bool DirectShares::restore(std::string_view from, size_t &at, size_t materials) {
    std::vector<uint8_t> flag;
    if (!get(from, at, flag, emitters) || flag.size() != 1) return false;
    seen = flag[0] != 0;
    for (size_t i = 0; i < emitters.size(); ++i)
        if (emitters[i] < 0 || (size_t)emitters[i] >= materials) return false;
    shares.resize(seen ? 0 : emitters.size());
    for (std::vector<float> &share : shares)
        if (!get(from, at, share)) return false;
    return get(from, at, outside);
}

bool DirectShares::fits(size_t texels) const {
    return (outside.empty() || outside.size() == texels) &&
           std::all_of(shares.begin(), shares.end(), [&](const auto &s) { return s.size() == texels; });
}

} // namespace odraz::radiosity
