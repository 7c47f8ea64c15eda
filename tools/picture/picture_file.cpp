#include "tools/picture/picture_file.h"

#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/picture/readers.h"

#include <cmath>
#include <utility>

namespace pictures {

namespace {

// Reads the first picture of `rest` and removes its bytes.
Picture takePicture(std::string_view &rest) {
    return isPnm(rest)   ? takePnm(rest)
           : isHdr(rest) ? takeHdr(rest)
           : isExr(rest) ? readExr(std::exchange(rest, {}))
                         : takeByStb(rest);
}

void checkLight(const Picture &p) {
    for (size_t i = 0; i < p.light.size(); ++i)
        if (!(std::fabs(p.light[i]) <= (float)kMostLight)) {
            size_t pixel = i / (size_t)p.channels, width = (size_t)p.width;
            throw common::Refused(common::format("its pixel %zu,%zu is %g; light must be a number up to %g",
                                                 pixel % width, pixel / width, (double)p.light[i],
                                                 kMostLight));
        }
}

template <class Body> auto withMemory(const std::string &name, Body body) {
    try {
        return body();
    } catch (const std::bad_alloc &) {
        throw common::Refused(name + ": not enough memory");
    }
}

} // namespace

PictureFile::PictureFile(const std::string &path)
    : PictureFile(path, withMemory(path, [&] { return common::readWhole(path); })) {}

PictureFile::PictureFile(const std::string &name, std::string bytes) : name(name), bytes(std::move(bytes)) {
    common::need(more(), name + ": it is empty");
}

Picture PictureFile::next() {
    std::string_view rest = std::string_view(bytes).substr(at);
    Picture p = withMemory(name, [&] { return common::inFile(name, [&] { return takePicture(rest); }); });
    at = bytes.size() - rest.size();
    common::inFile(name, [&] { checkLight(p); });
    return p;
}

static Picture onlyPicture(const std::string &name, PictureFile file) {
    Picture p = file.next();
    common::need(!file.more(), name + ": it holds more than one picture");
    return p;
}
Picture readPicture(const std::string &path) { return onlyPicture(path, PictureFile(path)); }
Picture readPicture(const std::string &name, std::string bytes) {
    return onlyPicture(name, PictureFile(name, std::move(bytes)));
}

} // namespace pictures
