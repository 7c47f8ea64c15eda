// contact_sheet: draws a page of frames of the film, every few seconds, with their times; or a poster.
#include "film.h"
#include "show/font.h"
#include "tools/common/command_line.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/picture/picture_file.h"

#include <cstring>
#include <optional>

namespace odraz {

using namespace pictures;

namespace {

// The moments of a poster, in seconds of the film; the large picture is first.
constexpr int kPosterMoments[] = {FILM_POSTER};

struct PixelBox {
    int x, y, width, height;
};

// Writes a text in the film's font over a box of the picture, which is first darkened to `shade`.
void writeText(Image &picture, const PixelBox &box, const char *text, const TextStyle &style,
               const uint8_t colour[3], float shade = 1) {
    size_t pixels = (size_t)box.width * (size_t)box.height;
    std::vector<float> planes(3 * pixels); // all three are equal; the first is used
    Frame frame = {box.width, box.height, box.width, {&planes[0], &planes[pixels], &planes[2 * pixels]},
                   nullptr,   nullptr};
    float x = style.align == Align::Left ? style.size / 2 : (float)box.width - style.size / 2;
    drawText(frame, text, x, ((float)box.height + style.size) / 2, style);
    for (int y = 0; y < box.height && box.y + y < picture.height; ++y)
        for (int x = 0; x < box.width && box.x + x < picture.width; ++x)
            for (int c = 0; c < 3; ++c) {
                uint8_t &p =
                    picture.rgb[((size_t)(box.y + y) * (size_t)picture.width + (size_t)(box.x + x)) * 3 +
                                (size_t)c];
                float below = (float)p * shade;
                p = (uint8_t)(below + ((float)colour[c] - below) * planes[(size_t)(y * box.width + x)]);
            }
}

// Writes minutes:seconds in the lower left corner of the picture.
void label(Image &picture, int seconds) {
    const std::string text = common::format("%d:%02d", seconds / 60, seconds % 60);
    static constexpr uint8_t kGrey[3] = {230, 230, 230};
    int height = std::min(20, picture.height);
    writeText(picture, {0, picture.height - height, 64, height}, text.c_str(),
              {10, 0.13f, Align::Left, {1, 1, 1}, 1, 1}, kGrey, 0.75f);
}

// Runs the program with --dump and `options`. Returns its frames, `width` pixels wide.
std::vector<Image> dumpFrames(const std::string &program, const std::string &options, int width,
                              const std::string &quality) {
    // Trace pictures of twice the size, since averaging makes them smoother
    int traced = width * 2;
    std::string command = common::shellWord(program) + " --dump - " + options + " --quality " +
                          common::shellWord(quality) + " --size " + std::to_string(traced) + "x" +
                          std::to_string(traced * 9 / 16);
    int status;
    std::string dump = common::outputOf(command, &status);
    if (status != 0 || dump.empty()) throw std::runtime_error(program + ": its --dump failed");
    std::vector<Image> frames;
    for (PictureFile file(program, std::move(dump)); file.more();)
        frames.push_back(shrink(toImage(file.next()), width));
    return frames;
}

std::vector<Image> framesOf(const std::string &program, int every, int width, const std::string &quality) {
    std::vector<Image> frames = dumpFrames(program, "--fps 1/" + std::to_string(every), width, quality);
    for (size_t i = 0; i < frames.size(); ++i) label(frames[i], every * (int)i);
    return frames;
}

void paste(Image &sheet, const Image &frame, int x, int y) {
    for (int row = 0; row < frame.height; ++row)
        std::memcpy(&sheet.rgb[((size_t)(y + row) * (size_t)sheet.width + (size_t)x) * 3],
                    &frame.rgb[(size_t)row * (size_t)frame.width * 3], (size_t)frame.width * 3);
}

// Draws a poster: a large picture, two rows of three small ones, and the title. The large one is also
// `still`.
Image poster(const std::string &program, int width, const std::string &quality, Image &still) {
    constexpr int kAcross = 3;
    const int gap = width / 100, small = (width - (kAcross - 1) * gap) / kAcross, high = small * 9 / 16,
              band = width / 12;
    Image page;
    int y = gap, shown = 0;
    for (int second : kPosterMoments) {
        std::string at = "--fps 1 --from " + std::to_string(second) + " --to " + std::to_string(second + 1);
        Image frame = dumpFrames(program, at, shown ? small : width, quality)[0];
        if (!shown) {
            page.width = width + 2 * gap;
            page.height = frame.height + 2 * high + 4 * gap + band;
            page.rgb.assign((size_t)page.width * (size_t)page.height * 3, 8);
            paste(page, frame, gap, y);
            y += frame.height + gap;
            still = frame;
        } else {
            int i = shown - 1;
            paste(page, frame, gap + i % kAcross * (small + gap), y + i / kAcross * (high + gap));
        }
        ++shown;
    }
    static constexpr uint8_t kCopper[3] = {236, 158, 92}, kGrey[3] = {170, 170, 176};
    PixelBox title = {gap, page.height - gap / 2 - band, page.width - 2 * gap, band};
    writeText(page, title, FILM_NAME, {(float)band * 0.42f, 0.1f, Align::Left, {1, 1, 1}, 1, 3}, kCopper);
    writeText(page, title, FILM_ABOUT, {(float)band * 0.19f, 0.1f, Align::Right, {1, 1, 1}, 1, 2}, kGrey);
    return page;
}

// Lays out frames of equal size, row by row.
Image layOut(const std::vector<Image> &frames) {
    constexpr int kColumns = 5, kGap = 6;
    const int width = frames[0].width, height = frames[0].height;
    int rows = ((int)frames.size() + kColumns - 1) / kColumns;
    Image sheet;
    sheet.width = kColumns * (width + kGap) + kGap;
    sheet.height = rows * (height + kGap) + kGap;
    sheet.rgb.assign((size_t)sheet.width * (size_t)sheet.height * 3, 24);
    for (int i = 0; i < (int)frames.size(); ++i)
        paste(sheet, frames[(size_t)i], i % kColumns * (width + kGap) + kGap,
              i / kColumns * (height + kGap) + kGap);
    return sheet;
}

int run(common::CommandLine &line) {
    std::string program, out, stillOut, quality;
    std::optional<int> width;
    int every = 5;
    bool asPoster = false;
    line.about(
        "Runs FILM, which dumps a frame every few seconds, and lays the frames out on one page. A poster "
        "has a large\nframe, two rows of three small frames, and the title.");
    line.argument("FILM", program, "the film's program");
    line.argument("OUT", out, "the page to write, OUT.png or OUT.jpg");
    line.option("--every", "SECONDS", every, {1, 4000}, "time between frames");
    line.option("--width", "PIXELS", width, {1, 4000},
                "width of a frame (default 384), or of the poster (default 1600)");
    line.option("--quality", "NAME", quality, "quality of the frames (default play; film for a poster)");
    line.flag("--poster", asPoster, "draw a poster");
    line.option("--still", "FILE", stillOut, "with --poster: also write its large frame, as .png or .jpg");
    line.parse();
    common::noteInput(program);
    for (const std::string &path : {out, stillOut}) {
        if (!path.empty()) common::claimOutput(path);
        formatNamed(path, Format::Jpeg); // refuses other formats
    }
    if (!stillOut.empty() && !asPoster) line.refuse("--still needs --poster");
    if (quality.empty()) quality = asPoster ? "film" : "play";
    if (asPoster) {
        Image still, page = poster(program, width.value_or(1600), quality, still);
        writeImage(out, page);
        if (!stillOut.empty()) writeImage(stillOut, still);
        std::printf("%s: a poster of %d x %d\n", out.c_str(), page.width, page.height);
        return 0;
    }
    std::vector<Image> frames = framesOf(program, every, width.value_or(384), quality);
    writeImage(out, layOut(frames));
    std::printf("%s: %s, one every %d s\n", out.c_str(), common::counted(frames.size(), "frame").c_str(),
                every);
    return 0;
}

} // namespace

} // namespace odraz

int main(int argc, char **argv) { return common::runProgram("contact_sheet", argc, argv, odraz::run); }
