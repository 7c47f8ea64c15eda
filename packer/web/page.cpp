// page: makes one HTML file of a WebAssembly program and its scripts.
//
// Program and scripts are deflated together, and stand in a comment of the page. There the bytes that HTML
// would change, or that would end the comment, are written as two: a 1, and themselves with a bit turned. All
// of them are turned by a key first, for which the fewest need that. As a file, the page is read as text in
// windows-1252, and a script turns its letters into bytes again. From a server, which may name another
// charset, the script fetches the page itself.
#include "tools/common/text.h"
#include "tools/common/whole_file.h"

#include <zopfli/zopfli.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace pack {

namespace {

constexpr char kUsage[] = "usage: page PROGRAM.wasm PAGE.html WORKER.js,... MAIN.js OUT.html BUDGET\n"
                          "The scripts of workers are given to main() of MAIN.js, as text, behind the "
                          "program. Fails when the page has more\n"
                          "than BUDGET bytes.\n";

// Without comments, which have lines of their own or follow two spaces, indentation and empty lines.
std::string shortened(const std::string &script) {
    std::string out;
    for (size_t at = 0; at < script.size();) {
        size_t end = std::min(script.find('\n', at), script.size());
        std::string line = script.substr(at, end - at);
        at = end + 1;
        line.erase(0, line.find_first_not_of(' ') == std::string::npos ? line.size()
                                                                       : line.find_first_not_of(' '));
        if (line.starts_with("//")) continue;
        line = line.substr(0, line.find(" // "));
        if (!line.empty()) out += line + '\n';
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

bool changedByHtml(unsigned char c) { return c == 0 || c == 1 || c == '\r' || c == '>'; }

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
            if (changedByHtml(turned)) out += (char)1, turned ^= 64;
            out += (char)turned;
        }
        if (!key || out.size() < best.bytes.size()) best = {out, key};
    }
    return best;
}

// Reads `s`, the packed bytes, and runs main().
std::string loader(size_t scriptSize, int key) {
    std::string text = R"((async()=>{let m={},s,t=document.currentScript.previousSibling.data,i=0,o=[]
if(!self.DecompressionStream||!self.WebAssembly)
throw document.querySelector('p').textContent='This browser is too old: it lacks WebAssembly or DecompressionStream.'
if(location.protocol=='file:'){
[...new TextDecoder('latin1').decode(Uint8Array.from({length:256},(_,i)=>i))].map((c,i)=>m[c]=i);s=[...t].map(c=>m[c])
}else{s=new Uint8Array(await(await fetch(location.href)).arrayBuffer());for(;s[i++]!=60||s[i]!=33||s[i+1]!=45;);i+=3}
for(;i<s.length&&s[i]!=62;){let c=s[i++];o.push((c==1?s[i++]^64:c)^KEY)}
s=new Blob([new Uint8Array(o)]).stream().pipeThrough(new DecompressionStream('deflate-raw'))
s=new Uint8Array(await new Response(s).arrayBuffer())
new Function('data',new TextDecoder().decode(s.subarray(0,SIZE)))(s.slice(SIZE))})())";
    auto put = [&](const std::string &what, size_t number) {
        for (size_t at; (at = text.find(what)) != std::string::npos;)
            text.replace(at, what.size(), std::to_string(number));
    };
    put("KEY", (size_t)key), put("SIZE", scriptSize);
    return text;
}

void makePage(char **words) {
    std::string program = common::readWhole(words[0]), html = common::readWhole(words[1]), workers,
                list = words[2];
    for (size_t at = 0; at < list.size();) {
        size_t end = std::min(list.find(',', at), list.size());
        workers += shortened(common::readWhole(list.substr(at, end - at)));
        at = end + 1;
    }
    std::string script =
        shortened(common::readWhole(words[3])) + "main(data," + quoted(workers + "work()") + ")";
    Escaped packed = escaped(deflated(script + program));
    std::string head;
    for (char c : shortened(html))
        if (c != '\n') head += c;
    std::string page =
        head + "<!--" + packed.bytes + "--><script>" + loader(script.size(), packed.key) + "</script>";
    common::writeWhole(words[4], page);
    long left = std::stol(words[5]) - (long)page.size();
    std::printf("%s: %zu bytes (scripts %zu, program %zu before packing), %ld left of %s\n", words[4],
                page.size(), script.size(), program.size(), left, words[5]);
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
        if (argc != 7) throw common::Refused("it takes six words: see page --help");
        pack::makePage(argv + 1);
        return 0;
    } catch (const common::Refused &e) {
        std::fprintf(stderr, "page: %s\n", e.what());
        return 2;
    } catch (const std::exception &e) {
        std::fprintf(stderr, "page: %s\n", e.what());
        return 1;
    }
}
