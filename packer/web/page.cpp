// page: makes one HTML file of a WebAssembly program and its scripts.
//
// Markup, scripts and program are coded together by the packer's model (surroundings.h). They stand behind
// their decoder (decode.cpp), which is deflated, in a comment of the page. There the bytes that HTML would
// change, or that would end the comment, are written as two: a 1, and themselves with a bit turned. All of
// them are turned by a key first, for which the fewest need that. As a file, the page is read as text in
// windows-1252, and a script turns its letters into bytes again. From a server, which may name another
// charset, the script fetches the page itself.
#include "packer/model/encoder.h"
#include "packer/model/search.h"
#include "packer/web/surroundings.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"

#include <zopfli/zopfli.h>

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace pack {

// Nothing in WebAssembly is relative to its place.
template <>
std::vector<uint8_t> filter<web::Surroundings>(const std::vector<uint8_t> &image, const Layout &) {
    return image;
}

namespace {

constexpr char kUsage[] =
    "usage: page PROGRAM.wasm DECODER.wasm MODEL PAGE.html WORKER.js,... MAIN.js,... OUT.html BUDGET "
    "[SECONDS]\n"
    "The scripts of workers are given to main() of MAIN.js,..., as text, behind the program. Fails when\n"
    "the page has more than BUDGET bytes. With SECONDS, it first searches for better contexts, and renews\n"
    "MODEL.\n";

// Without comments, which have lines of their own or follow two spaces, indentation and empty lines.
std::string shortened(const std::string &script) {
    std::string out;
    for (size_t at = 0; at < script.size();) {
        size_t end = std::min(script.find('\n', at), script.size());
        std::string line = script.substr(at, end - at);
        at = end + 1;
        line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
        if (line.starts_with("//")) continue;
        line = line.substr(0, line.find(" // "));
        if (!line.empty()) out += line + '\n';
    }
    return out;
}

// A script without spaces beside punctuation, except in strings.
std::string tight(const std::string &script) {
    std::string out;
    char quote = 0;
    auto sign = [](char c) { return c == '+' || c == '-'; };
    auto word = [](char c) { return std::isalnum((unsigned char)c) || c == '_' || c == '$'; };
    for (size_t i = 0; i < script.size(); ++i) {
        char c = script[i], before = out.empty() ? ' ' : out.back(), after = script[i + 1];
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '\'' || c == '"' || c == '`')
            quote = c;
        else if (c == ' ' && !(word(before) && word(after)) && !(sign(before) && sign(after)))
            continue;
        out += c;
    }
    return out;
}

// As a string of JavaScript.
std::string quoted(const std::string &text) {
    std::string out = "`";
    for (char c : text) {
        if (c == '`' || c == '\\' || c == '$') out += '\\';
        out += c;
    }
    return out + '`';
}

// Without a header and a checksum.
std::string deflated(const std::string &bytes) {
    ZopfliOptions options;
    ZopfliInitOptions(&options);
    unsigned char *out = nullptr;
    size_t size = 0;
    ZopfliCompress(&options, ZOPFLI_FORMAT_DEFLATE, (const unsigned char *)bytes.data(), bytes.size(), &out,
                   &size);
    std::string result((const char *)out, size);
    std::free(out);
    return result;
}

// Whether a byte of a comment, behind another one, would be changed by HTML or end the comment; or is our
// mark.
bool mustEscape(unsigned char c, char before) {
    return c == 0 || c == 1 || c == '\r' || (c == '>' && (before == '-' || before == '!'));
}

struct Escaped {
    std::string bytes;
    int key;
};
Escaped escaped(const std::string &bytes) {
    Escaped best;
    for (int key = 0; key < 256; ++key) {
        std::string out;
        for (char c : bytes) {
            unsigned char turned = (unsigned char)(c ^ key);
            if (mustEscape(turned, out.empty() ? '-' : out.back())) out += (char)1, turned ^= 64;
            out += (char)turned;
        }
        if (!key || out.size() < best.bytes.size()) best = {out, key};
    }
    return best;
}

// Where the code of a program lies in `all`, which begins with scripts.
Layout layoutOf(const std::string &all, size_t program) {
    size_t at = program + 8;
    auto number = [&] {
        uint32_t value = 0;
        for (int shift = 0;; shift += 7) {
            auto c = (unsigned char)all.at(at++);
            value |= (c & 127u) << shift;
            if (c < 128) return value;
        }
    };
    while (at < all.size()) {
        int section = all[at++];
        size_t size = number(), end = at + size;
        if (section == 10) {
            number(); // of functions
            return {(uint32_t)all.size(), (uint32_t)at, (uint32_t)(end - at)};
        }
        at = end;
    }
    throw std::runtime_error("the program has no code");
}

// plain.js finds relaxed instructions by their bytes alone. Refuses a program where others look like them.
void checkRelaxed(const std::vector<uint8_t> &bytes, const Layout &layout) {
    web::Parser parser = {};
    uint32_t fields[web::kFields] = {};
    for (uint32_t i = layout.codeBegin; i + 2 < layout.codeBegin + layout.codeSize; ++i) {
        uint8_t kind = bytes[i + 1];
        bool looks = bytes[i] == 0xfd && bytes[i + 2] == 2 && (kind == 0x81 || kind == 0x85 || kind == 0x8b);
        if (looks && parser.phase != web::Parser::kOpcodeByte)
            throw std::runtime_error("the program has a number that looks like a relaxed instruction, which "
                                     "plain.js would change: change some address or constant");
        parser.step(fields, bytes[i]);
    }
}

// The masks of code and data, as hexadecimal numbers.
ModelParameters readModel(const std::string &path) {
    std::istringstream text(common::readWhole(path));
    ModelParameters parameters = {16, 22, {}};
    for (auto &type : parameters.masks)
        for (uint32_t &mask : type) text >> std::hex >> mask;
    if (!text || !parameters.sane(web::Surroundings::mayUse))
        throw common::Refused(path + ": these are no masks");
    return parameters;
}
void writeModel(const std::string &path, const ModelParameters &parameters) {
    std::string text;
    for (auto &type : parameters.masks)
        for (uint32_t i = 0; i < parameters.hashes(); ++i)
            common::append(text, "%x%c", type[i], i + 1 < parameters.hashes() ? ' ' : '\n');
    common::writeWhole(path, text);
}

// In: the comment's text `t`, or the page `s` itself; out: what the decoder makes of it, a script, which is
// run with the program. The decoder works on a thread of its own, so that the page answers. What fails, as
// workers, scripts and WebAssembly do by a Content-Security-Policy, is one sentence. A click is remembered.
constexpr char kLoader[] =
    R"((async()=>{let m={},s,t=document.currentScript.previousSibling.data,i=0,o=[],w,e=onerror=onunhandledrejection=()=>{
document.body.textContent='This browser or site allows no WebAssembly, workers or DecompressionStream: it cannot play the film.'}
onclick=()=>clicked=1
if(document.characterSet[0]=='w'){
[...new TextDecoder('latin1').decode(Uint8Array.from({length:256},(_,i)=>i))].map((c,i)=>m[c]=i)
s=[...t].map(c=>m[c])
}else{s=new Uint8Array(await(await fetch(location.href)).arrayBuffer());for(;s[i++]!=60||s[i]!=33||s[i+1]!=45;);i+=3}
for(;o.length<COUNT;){let c=s[i++];o.push((c==1?s[i++]^64:c)^KEY)}
o=new Uint8Array(o)
w=new Worker(URL.createObjectURL(new Blob([`onmessage=async({data:[h,o]})=>{let x=(await WebAssembly.instantiate(h.slice(
MODEL))).instance.exports,b=new Uint8Array(x.memory.buffer),i=x.i()
b.set(h.slice(0,MODEL),i);b.set(o,i+MODEL);i=x.d();postMessage(b.slice(i,i+ALL))}
onunhandledrejection=e=>{throw e}`])))
w.onerror=e
w.onmessage=({data:s})=>{w.terminate()
new Function('data',new TextDecoder().decode(s.slice(0,SCRIPT)))(s.slice(SCRIPT))}
s=new Blob([o.slice(0,HEAD)]).stream().pipeThrough(new DecompressionStream('deflate-raw'))
w.postMessage([new Uint8Array(await new Response(s).arrayBuffer()),o.slice(HEAD)])})())";

// The scripts of a list with commas.
std::string scriptsOf(const std::string &list) {
    std::istringstream names(list);
    std::string all;
    for (std::string name; std::getline(names, name, ',');) all += tight(shortened(common::readWhole(name)));
    return all;
}

void makePage(char **words, double seconds) {
    std::string program = common::readWhole(words[0]), decoder = common::readWhole(words[1]);
    ModelParameters parameters = readModel(words[2]);
    // The markup's first line stands in the page as it is; a script adds the rest
    std::string html = shortened(common::readWhole(words[3])), first = html.substr(0, html.find('\n'));
    std::string script = "document.body.innerHTML=" + quoted(html.substr(first.size() + 1)) + "\n" +
                         scriptsOf(words[5]) + "main(data," + quoted(scriptsOf(words[4])) + ")";

    std::string all = script + program;
    std::vector<uint8_t> bytes(all.begin(), all.end());
    Layout layout = layoutOf(all, script.size());
    checkRelaxed(bytes, layout);
    if (seconds > 0) {
        parameters = search<web::Surroundings>(bytes, layout, parameters, seconds,
                                               [](const Progress &) { return true; });
        writeModel(words[2], parameters);
    }
    Workspace workspace;
    Encoded encoded = encode<web::Surroundings>(bytes, layout, parameters, workspace);
    if (decode<web::Surroundings>(encoded.payload.data(), encoded.payload.size(), layout, parameters,
                                  workspace) != bytes)
        throw std::runtime_error("the decoder does not decode");
    std::string model((const char *)&layout, sizeof layout);
    model.append((const char *)&parameters, sizeof parameters);
    std::string head = deflated(model + decoder);
    std::string coded = head + std::string(encoded.payload.begin(), encoded.payload.end());
    Escaped packed = escaped(coded);

    std::string loader = kLoader;
    auto put = [&](const std::string &what, size_t number) {
        for (size_t at; (at = loader.find(what)) != std::string::npos;)
            loader.replace(at, what.size(), std::to_string(number));
    };
    put("KEY", (size_t)packed.key), put("COUNT", coded.size()), put("HEAD", head.size()),
        put("MODEL", model.size());
    put("ALL", all.size()), put("SCRIPT", script.size());
    std::string page = first + "<!--" + packed.bytes + "--><script>" + loader + "</script>";
    common::writeWhole(words[6], page);
    long left = std::stol(words[7]) - (long)page.size();
    std::printf("%s: %zu bytes (%zu coded, of scripts %zu and program %zu; decoder %zu; loader %zu), %ld "
                "left of %s\n",
                words[6], page.size(), encoded.payload.size(), script.size(), program.size(), head.size(),
                first.size() + loader.size(), left, words[7]);
    if (left < 0) throw std::runtime_error("over budget by " + std::to_string(-left) + " bytes");
}

} // namespace

} // namespace pack

int main(int argc, char **argv) {
    try {
        if (argc == 2 && argv[1] == std::string("--help")) {
            std::fputs(pack::kUsage, stdout);
            return 0;
        }
        if (argc != 9 && argc != 10) throw common::Refused("it takes eight or nine words: see page --help");
        pack::makePage(argv + 1, argc == 10 ? std::atof(argv[9]) : 0);
        return 0;
    } catch (const std::exception &e) {
        std::fprintf(stderr, "page: %s\n", e.what());
        return dynamic_cast<const common::Refused *>(&e) ? 2 : 1;
    }
}
