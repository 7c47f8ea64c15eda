#include "tools/picture/readers.h"

#include "tools/common/command_line.h"
#include "tools/common/text.h"

#include <cctype>

namespace pictures {

namespace {

constexpr const char *kEnds = "it ends before its last pixel";

class PnmReader {
public:
    explicit PnmReader(std::string_view file) : file(file) {}

    Picture read() {
        char kind = file[1];
        common::need(std::string_view("2356").find(kind) != std::string_view::npos,
                     common::format("it is a P%c file; of PNM, only P2, P3, P5 and P6 are read", kind));
        bool text = kind < '5';
        Picture p = {(int)number("width", 1, kMostPixels), (int)number("height", 1, kMostPixels),
                     kind == '2' || kind == '5' ? 1 : 3};
        common::need((int64_t)p.width * p.height <= kMostPixels, "it has more than 2^27 pixels");
        most = (uint32_t)number("largest value", 1, 65535);
        p.bits = most > 255 ? 16 : 8;
        if (!text) {
            skipComment();
            common::need(at < file.size(), kEnds);
            common::need(std::isspace((uint8_t)file[at++]),
                         "it has no space between its header and its pixels");
        }
        size_t count = p.pixels() * (size_t)p.channels, each = text || most > 255 ? 2 : 1;
        // In text the last byte may be a digit, without a blank after it
        common::need(file.size() - at + text >= count * each, kEnds);
        p.encoded.resize(count);
        for (uint16_t &to : p.encoded) {
            uint32_t value = text ? (uint32_t)number("pixel", 0, most) : bytes(each);
            common::need(value <= most, "it has a pixel above its largest value");
            to = (uint16_t)((value * 65535 + most / 2) / most);
        }
        while (text && at < file.size() && std::isspace((uint8_t)file[at])) ++at;
        return p;
    }
    std::string_view rest() const { return file.substr(at); }

private:
    std::string_view file;
    size_t at = 2; // after "P6"
    uint32_t most = 0;

    void skipComment() {
        if (at < file.size() && file[at] == '#')
            while (at < file.size() && file[at] != '\n' && file[at] != '\r') ++at;
    }

    int64_t number(const char *what, int64_t least, int64_t greatest) {
        for (; at < file.size() && (std::isspace((uint8_t)file[at]) || file[at] == '#'); ++at) skipComment();
        common::need(at < file.size(), kEnds);
        int64_t value = 0;
        size_t first = at;
        for (; at < file.size() && std::isdigit((uint8_t)file[at]) && value <= greatest; ++at)
            value = value * 10 + file[at] - '0';
        common::need(at > first && value >= least && value <= greatest,
                     std::string("it has a ") + what + " that is not from " + std::to_string(least) + " to " +
                         std::to_string(greatest));
        return value;
    }

    uint32_t bytes(size_t count) { // the highest byte first
        uint32_t value = 0;
        for (; count; --count) value = value << 8 | (uint8_t)file[at++];
        return value;
    }
};

} // namespace

bool isPnm(std::string_view file) {
    return file.size() > 2 && file[0] == 'P' && std::string_view("1234567fF").find(file[1]) != file.npos &&
           (std::isspace((uint8_t)file[2]) || file[2] == '#');
}

Picture takePnm(std::string_view &file) {
    PnmReader reader(file);
    Picture p = reader.read();
    file = reader.rest();
    common::need(file.empty() || isPnm(file), std::to_string(file.size()) + " bytes follow its last pixel");
    return p;
}

} // namespace pictures
