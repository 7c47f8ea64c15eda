#include "tools/picture/plot.h"

#include "tools/common/text.h"

#include <algorithm>
#include <cmath>

namespace pictures {

namespace {

constexpr double kLeft = 80, kTop = 40, kBottom = 60; // margins
constexpr double kLeastKey = 170;                     // the least width of the legend, right of the plot
constexpr double kSeriesLine = 20, kPointLine = 13;   // heights of the legend's lines
constexpr double kMark = 4, kShippedMark = 6;
constexpr const char *kColours[] = {"#b5562a", "#2f6f8f", "#5a7d2b", "#7a4b8c", "#8a7a20",
                                    "#555555", "#c2871c", "#1c8c7a", "#a03a5c", "#3a50a0"};
// Paths of marks in a square from -1 to 1: circle, square, triangle, cross, diamond, plus, inverted triangle,
// hourglass, bow tie, star. Closed marks are filled.
constexpr const char *kMarks[] = {
    "M-1 0A1 1 0 1 1 1 0A1 1 0 1 1-1 0Z",
    "M-.9-.9H.9V.9H-.9Z",
    "M0-1L1 .8H-1Z",
    "M-1-1L1 1M-1 1L1-1",
    "M0-1L1 0L0 1L-1 0Z",
    "M0-1V1M-1 0H1",
    "M-1-.8H1L0 1Z",
    "M-1-1H1L-1 1H1Z",
    "M-1-1L1 1V-1L-1 1Z",
    "M0-1V1M-1 0H1M-.7-.7L.7 .7M-.7 .7L.7-.7",
};
constexpr int kMarkCount = sizeof kMarks / sizeof *kMarks, kColourCount = sizeof kColours / sizeof *kColours;

using common::format;

// An axis: maps values to positions, and finds round values for its ticks.
struct Axis {
    bool logarithmic;
    double low, high, from, to;

    Axis(bool isLogarithmic, double least, double most, double begin, double end)
        : logarithmic(isLogarithmic), low(scale(least)), high(scale(most)), from(begin), to(end) {
        double margin = high > low ? (high - low) * 0.06 : 0.5;
        low -= margin;
        high += margin;
    }
    double scale(double v) const { return logarithmic ? std::log10(v) : v; }
    double position(double v) const { return from + (scale(v) - low) / (high - low) * (to - from); }
    std::vector<double> ticks() const {
        std::vector<double> all;
        auto inside = [&](double v) { return scale(v) >= low && scale(v) <= high; };
        if (logarithmic)
            for (double decade = std::floor(low); decade <= high; ++decade)
                for (double m : {1.0, 2.0, 5.0})
                    if (double v = m * std::pow(10, decade); inside(v)) all.push_back(v);
        if (all.size() > 2) return all;
        // Use equal steps on a linear axis, or within a part of a decade
        all.clear();
        double first = logarithmic ? std::pow(10, low) : low, last = logarithmic ? std::pow(10, high) : high,
               step = std::pow(10, std::floor(std::log10((last - first) / 4)));
        while ((last - first) / step > 8) step *= (last - first) / step > 16 ? 5 : 2;
        for (double v = std::ceil(first / step) * step; v <= last; v += step)
            if (inside(v)) all.push_back(v + 0.0); // no -0
        return all;
    }
};

// The legend's width: enough for the longest name, at about 6.6 a letter.
double keyWidth(const Plot &plot) {
    size_t longest = 0;
    for (const std::string &name : plot.series) longest = std::max(longest, name.size());
    for (const PlotPoint &p : plot.points) longest = std::max(longest, p.name.size());
    return std::max(kLeastKey, 50 + 6.6 * (double)longest);
}
// The plot's height: enough for the legend
double heightOf(const Plot &plot) {
    double lines = kSeriesLine * (double)plot.series.size();
    for (const PlotPoint &p : plot.points) lines += p.name.empty() ? 0 : kPointLine;
    return std::max(460., kTop + lines + kBottom);
}

class PlotDrawing {
public:
    explicit PlotDrawing(const Plot &of)
        : plot(of), height(heightOf(of)), key(keyWidth(of)),
          x(of.logarithmicX, least(0), -least(0, -1), kLeft, width - key),
          y(of.logarithmicY, least(1), -least(1, -1), height - kBottom, kTop) {}
    std::string svg() {
        out = format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" "
            "font-size=\"12\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
            width, height);
        axes();
        fronts();
        legend();
        return out + "</svg>\n";
    }

private:
    const Plot &plot;
    double width = 930, height, key; // the legend's width
    Axis x, y;
    std::string out;

    // The least value on an axis; if the sign is -1, the greatest value, negated.
    double least(int axis, double sign = 1) const {
        double v = 1e300;
        for (const PlotPoint &p : plot.points) v = std::min(v, sign * (axis ? p.y : p.x));
        return v;
    }

    void text(double px, double py, const char *anchor, const std::string &what,
              const std::string &more = "") {
        out += format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>", px, py, anchor, more.c_str()) +
               common::htmlText(what) + "</text>\n";
    }

    void mark(double px, double py, int series, double size, const char *kind) {
        const char *colour = kColours[series % kColourCount];
        int which = series % kMarkCount;
        bool filled = std::string(kMarks[which]).back() == 'Z';
        out += format("<path class=\"%s\" transform=\"translate(%.1f %.1f) scale(%g)\" d=\"%s\" fill=\"%s\" "
                      "stroke=\"%s\" stroke-width=\"%.2f\"/>\n",
                      kind, px, py, size, kMarks[which], filled ? colour : "none", colour, 1.6 / size);
    }

    void axes() {
        text((kLeft + width - key) / 2, 22, "middle", plot.title, " font-size=\"15\"");
        text((kLeft + width - key) / 2, height - 12, "middle", plot.xName);
        text(0, 0, "middle", plot.yName, format(" transform=\"translate(18 %.0f) rotate(-90)\"", height / 2));
        for (double v : x.ticks()) {
            out += format("<path d=\"M%.1f %.1fV%.1f\" stroke=\"#e9e9e9\"/>\n", x.position(v), kTop,
                          height - kBottom);
            text(x.position(v), height - kBottom + 18, "middle", format("%g", v));
        }
        for (double v : y.ticks()) {
            out += format("<path d=\"M%.1f %.1fH%.1f\" stroke=\"#e9e9e9\"/>\n", kLeft, y.position(v),
                          width - key);
            text(kLeft - 8, y.position(v) + 4, "end", format("%g", v));
        }
    }

    std::vector<PlotPoint> ofSeries(int series) const {
        std::vector<PlotPoint> all;
        for (const PlotPoint &p : plot.points)
            if (p.series == series) all.push_back(p);
        return all;
    }

    // The points of a series that none of its other points beats
    std::vector<PlotPoint> front(int series) const {
        const std::vector<PlotPoint> all = ofSeries(series);
        std::vector<PlotPoint> best;
        for (const PlotPoint &p : all)
            if (std::none_of(all.begin(), all.end(), [&](const PlotPoint &q) {
                    return q.x <= p.x && q.y <= p.y && (q.x < p.x || q.y < p.y);
                }))
                best.push_back(p);
        std::sort(best.begin(), best.end(), [](auto &a, auto &b) { return a.x < b.x; });
        return best;
    }

    // Draws the fronts, or lines through all points of each series
    void fronts() {
        for (int series = 0; series < (int)plot.series.size(); ++series) {
            std::string path;
            for (const PlotPoint &p : plot.joined ? ofSeries(series) : front(series))
                path += format("%s%.1f %.1f", path.empty() ? "M" : "L", x.position(p.x), y.position(p.y));
            out += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + kColours[series % kColourCount] +
                   (plot.joined ? "\" stroke-width=\"1.5\"/>\n" : "\" stroke-dasharray=\"4 3\"/>\n");
        }
    }

    // Draws points and legend of all series. A point with a name gets a number at its mark and in the legend
    void legend() {
        double left = width - key + 20, at = kTop + 12;
        int number = 0;
        for (int series = 0; series < (int)plot.series.size(); ++series) {
            mark(left, at - 4, series, kMark, "key");
            text(left + 12, at, "start", plot.series[(size_t)series]);
            for (const PlotPoint &p : ofSeries(series)) {
                double px = x.position(p.x), py = y.position(p.y), size = p.shipped ? kShippedMark : kMark;
                mark(px, py, series, size, "mark");
                if (p.name.empty()) continue;
                // A white outline covers the lines below
                const char *look = p.shipped ? " font-size=\"10\" font-weight=\"bold\"" : " font-size=\"10\"";
                std::string which = std::to_string(++number);
                text(px + size + 2, py - 2, "start", which,
                     std::string(look) + " paint-order=\"stroke\" stroke=\"white\" stroke-width=\"2\"");
                text(left + 26, at += kPointLine, "end", which, look);
                text(left + 32, at, "start", p.name, std::string(look) + " class=\"name\"");
            }
            at += kSeriesLine;
        }
    }
};

} // namespace

std::string svg(const Plot &plot) { return PlotDrawing(plot).svg(); }

} // namespace pictures
