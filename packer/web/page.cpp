// page: makes one HTML file of a WebAssembly program and its scripts.
//
// The packer's model codes markup, scripts and program together (wasm_tracker.h). The page has a comment with
// the decoder (decode.cpp), deflated, and the coded bytes. Each block of BLOCK bytes is XORed with a key, the
// byte before it, so that it has no byte that HTML would change or that would end the comment. A browser
// reads a page that is opened as a file as text in windows-1252, and the script converts its characters back
// to bytes. A server may name another charset; then the script fetches the page again, as bytes.
#include "packer/model/encoder.h"
#include "packer/model/search.h"
#include "packer/web/wasm_tracker.h"
#include "packer/write/packed_file.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"

#include <zopfli/zopfli.h>

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

namespace pack {

// WebAssembly has no relative operands.
template <> Bytes filter<web::WasmTracker>(const Bytes &image, const Layout &) { return image; }

namespace {

constexpr char kUsage[] =
    "usage: page PROGRAM.wasm DECODER.wasm MODEL PAGE.html WORKER.js,... MAIN.js,... OUT.html BUDGET "
    "[SECONDS]\n"
    "Calls main(program, text) of the scripts MAIN.js,... in the page; the text is the workers' scripts.\n"
    "Fails, and removes OUT.html, if the page has more than BUDGET bytes. With SECONDS, first searches for\n"
    "better contexts and writes them to MODEL.\n";

// Removes indentation, empty lines and comments. A comment has its own line or follows a space.
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

// Removes the spaces next to punctuation, except in strings.
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

// Returns the text as a string literal of JavaScript.
std::string quoted(const std::string &text) {
    std::string out = "`";
    for (char c : text) {
        if (c == '`' || c == '\\' || c == '$') out += '\\';
        out += c;
    }
    return out + '`';
}

// Deflates, without header and checksum.
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

// Whether HTML would change a byte of this text in a comment, or end the comment there.
bool hasSpecial(const std::string &text) {
    for (size_t i = 1; i < text.size(); ++i)
        if (!text[i] || text[i] == '\r' || (text[i] == '>' && (text[i - 1] == '-' || text[i - 1] == '!')))
            return true;
    return false;
}

// XORs each block of `size` bytes with a key that leaves no special byte, and puts the key before the block.
// Returns an empty string if a block has no such key.
std::string masked(const std::string &bytes, size_t size) {
    std::string out = "-"; // the last byte of "<!--"
    for (size_t at = 0; at < bytes.size(); at += size) {
        std::string block;
        int key = 0;
        do {
            if (++key > 255) return {};
            block = '\0' + bytes.substr(at, size); // 0 becomes the key
            for (char &c : block) c ^= (char)key;
        } while (hasSpecial(out.back() + block));
        out += block;
    }
    return out.substr(1);
}

// Finds the code section. `all`: the scripts, then the WebAssembly program, from the offset `program` on.
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
            number(); // the count of functions
            return {(uint32_t)all.size(), (uint32_t)at, (uint32_t)(end - at)};
        }
        at = end;
    }
    throw std::runtime_error("the program has no code");
}

// plain.js finds relaxed SIMD instructions by their bytes alone. Throws if other bytes look like one.
void checkRelaxed(const Bytes &bytes, const Layout &layout) {
    web::WasmParser parser = {};
    uint32_t fields[web::kFields] = {};
    for (uint32_t i = layout.codeBegin; i + 2 < layout.codeBegin + layout.codeSize; ++i) {
        uint8_t kind = bytes[i + 1];
        bool relaxed =
            bytes[i] == 0xfd && bytes[i + 2] == 2 && (kind == 0x81 || kind == 0x85 || kind == 0x8b);
        if (relaxed && parser.phase != web::WasmParser::kOpcodeByte)
            throw std::runtime_error("a number in the program looks like a relaxed instruction, so plain.js "
                                     "would change it: change an address or a constant");
        parser.step(fields, bytes[i]);
    }
}

// Reads the masks of code and data: hexadecimal numbers.
ModelParameters readModel(const std::string &path) {
    std::istringstream text(common::readWhole(path));
    ModelParameters parameters = {16, 22, {}};
    for (auto &type : parameters.masks)
        for (uint32_t &mask : type) text >> std::hex >> mask;
    if (!text || !parameters.sane(web::WasmTracker::mayUse))
        throw common::Refused(path + ": not a model file of page");
    return parameters;
}
void writeModel(const std::string &path, const ModelParameters &parameters) {
    std::string text;
    for (auto &type : parameters.masks)
        for (uint32_t i = 0; i < parameters.hashes(); ++i)
            common::append(text, "%x%c", type[i], i + 1 < parameters.hashes() ? ' ' : '\n');
    common::writeWhole(path, text);
}

// The script in the page. It decodes the text `t` of the comment, or the page `s` itself, and runs kStarter.
// If something fails, for example because a Content-Security-Policy forbids workers or WebAssembly, the page
// shows one sentence. A click before the program starts is remembered.
constexpr char kLoader[] =
    R"((async()=>{let m={},s,t=document.currentScript.previousSibling.data,i=0,o=[],k,e=()=>{
document.body.textContent='This browser or site allows no WebAssembly, workers or DecompressionStream: it cannot play the film.'}
onclick=()=>clicked=1
try{if(document.characterSet=='windows-1252'){
[...new TextDecoder('latin1').decode(Uint8Array.from({length:256},(_,i)=>i))].map((c,i)=>m[c]=i)
s=[...t].map(c=>m[c])
}else{s=new Uint8Array(await(await fetch(location.href)).arrayBuffer());i=BEGIN}
for(;o.length<COUNT;o.push(s[i++]^k))if(o.length%BLOCK<1)k=s[i++]
o=new Uint8Array(o)
s=new Blob([o.slice(0,HEAD)]).stream().pipeThrough(new DecompressionStream('deflate-raw'))
s=new Uint8Array(await new Response(s).arrayBuffer());o=o.slice(HEAD)
eval(new TextDecoder().decode(s.slice(DECODER)))}catch{e()}})())";

// The script that is deflated after the decoder. It decodes `o` in a worker, which reports how many bytes are
// decoded, so that the page stays responsive. Then it runs the decoded script with the program.
constexpr char kStarter[] =
    R"js(let w=new Worker(URL.createObjectURL(new Blob([`onmessage=async({data:[s,o]})=>{let x=(await WebAssembly.instantiate(s.slice(
MODEL),{e:{p:postMessage}})).instance.exports,b=new Uint8Array(x.memory.buffer),i=x.i()
b.set(s.slice(0,MODEL),i);b.set(o,i+MODEL);i=x.d();postMessage(b.slice(i,i+ALL))}
onunhandledrejection=e=>{throw e}`])))
w.onerror=e
w.onmessage=({data:s})=>{if(s.length){w.terminate()
new Function('data',new TextDecoder().decode(s.slice(0,SCRIPT)))(s.slice(SCRIPT))
}else document.body.innerHTML=`<div style="position:fixed;left:30%;top:49%;width:40%;text-align:center;background:linear-gradient(90deg,#cc6b3d ${
s=s*100/ALL|0}%,#1d100a 0">unpacking ${document.title} ${s} %</div>`}
w.postMessage([s.slice(0,DECODER),o]))js";

// Replaces names in a script by numbers.
std::string filled(std::string script, std::initializer_list<std::pair<std::string, size_t>> numbers) {
    for (const auto &[name, number] : numbers)
        for (size_t at; (at = script.find(name)) != std::string::npos;)
            script.replace(at, name.size(), std::to_string(number));
    return script;
}

// Reads the scripts of a comma-separated list.
std::string scriptsOf(const std::string &list) {
    std::istringstream names(list);
    std::string all;
    for (std::string name; std::getline(names, name, ',');) all += tight(shortened(common::readWhole(name)));
    return all;
}

void makePage(char **words, double seconds) {
    std::string program = common::readWhole(words[0]), decoder = common::readWhole(words[1]);
    ModelParameters parameters = readModel(words[2]);
    // The first line of the markup begins the page; a script adds the rest
    std::string html = shortened(common::readWhole(words[3])), first = html.substr(0, html.find('\n'));
    std::string script = "document.body.innerHTML=" + quoted(html.substr(first.size() + 1)) + "\n" +
                         scriptsOf(words[5]) + "main(data," + quoted(scriptsOf(words[4])) + ")";

    std::string all = script + program;
    Bytes bytes(all.begin(), all.end());
    Layout layout = layoutOf(all, script.size());
    checkRelaxed(bytes, layout);
    if (seconds > 0) {
        parameters = search<web::WasmTracker>(bytes, layout, parameters, seconds,
                                              [](const Progress &) { return true; });
        writeModel(words[2], parameters);
    }
    Encoded encoded = encode<web::WasmTracker>(bytes, layout, parameters);
    if (decode<web::WasmTracker>(encoded.payload, layout, parameters) != bytes)
        throw std::runtime_error("verification failed: the page decodes to other bytes");
    std::string model((const char *)&layout, sizeof layout);
    model.append((const char *)&parameters, sizeof parameters);
    std::string starter = filled(kStarter, {{"MODEL", model.size()},
                                            {"DECODER", model.size() + decoder.size()},
                                            {"ALL", all.size()},
                                            {"SCRIPT", script.size()}});
    std::string head = deflated(model + decoder + starter);
    std::string coded = head + std::string(encoded.payload.begin(), encoded.payload.end());
    size_t block = 1024; // the largest that all have a key
    std::string packed;
    while ((packed = masked(coded, block)).empty()) --block;
    std::string loader = filled(kLoader, {{"BEGIN", first.size() + 4},
                                          {"COUNT", coded.size()},
                                          {"BLOCK", block},
                                          {"HEAD", head.size()},
                                          {"DECODER", model.size() + decoder.size()}});
    std::string page = first + "<!--" + packed + "--><script>" + loader + "</script>";
    long budget = std::stol(words[7]);
    checkBudget(words[6], page.size(), budget);
    common::writeWhole(words[6], page);
    std::printf("%s: %zu bytes (%zu coded, of scripts %zu and program %zu; decoder %zu; loader %zu), %ld "
                "left of %ld\n",
                words[6], page.size(), encoded.payload.size(), script.size(), program.size(), head.size(),
                first.size() + loader.size(), budget - (long)page.size(), budget);
}

} // namespace

} // namespace pack

int main(int argc, char **argv) {
    try {
        if (argc == 2 && (argv[1] == std::string("--help") || argv[1] == std::string("-h"))) {
            std::fputs(pack::kUsage, stdout);
            return 0;
        }
        if (argc != 9 && argc != 10) throw common::Refused("expected 8 or 9 arguments: see page --help");
        pack::makePage(argv + 1, argc == 10 ? std::atof(argv[9]) : 0);
        return 0;
    } catch (const std::exception &e) {
        std::fprintf(stderr, "page: %s\n", e.what());
        return dynamic_cast<const common::Refused *>(&e) ? 2 : 1;
    }
}
