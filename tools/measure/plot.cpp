#include "tools/measure/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr double kWidth = 760, kHeight = 460, kLeft = 80, kRight = 20, kTop = 40, kBottom = 60;
constexpr const char *kColours[] = {"#b5562a", "#2f6f8f", "#5a7d2b", "#7a4b8c", "#8a7a20",
                                    "#555555", "#c2871c", "#1c8c7a", "#a03a5c", "#3a50a0"};
constexpr int kColourCount = sizeof kColours / sizeof *kColours;

std::string format(const char *pattern, auto... values) {
    char text[600];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::string escaped(const std::string &text) {
    std::string out;
    for (char c : text)
        out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

// One axis: values to places, and round values to write on it.
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
    double place(double v) const { return from + (scale(v) - low) / (high - low) * (to - from); }
    std::vector<double> ticks() const {
        std::vector<double> all;
        if (logarithmic)
            for (double decade = std::floor(low); decade <= high; ++decade)
                for (double m : {1.0, 2.0, 5.0}) all.push_back(m * std::pow(10, decade));
        else {
            double step = std::pow(10, std::floor(std::log10((high - low) / 4)));
            while ((high - low) / step > 8) step *= (high - low) / step > 16 ? 5 : 2;
            for (double v = std::ceil(low / step) * step; v <= high; v += step) all.push_back(v);
        }
        std::erase_if(all, [&](double v) { return scale(v) < low || scale(v) > high; });
        return all;
    }
};

} // namespace

std::string svg(const Plot &plot) {
    double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
    for (auto &p : plot.points) {
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    Axis x(plot.logarithmicX, x0, x1, kLeft, kWidth - kRight),
        y(plot.logarithmicY, y0, y1, kHeight - kBottom, kTop);
    std::string out = format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" "
        "font-size=\"12\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
        kWidth, kHeight);
    auto text = [&](double px, double py, const char *anchor, const std::string &what,
                    const char *more = "") {
        out += format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>", px, py, anchor, more) +
               escaped(what) + "</text>\n";
    };
    text(kWidth / 2, 22, "middle", plot.title, " font-size=\"15\"");
    text(kWidth / 2, kHeight - 12, "middle", plot.xName);
    text(0, 0, "middle", plot.yName,
         format(" transform=\"translate(18 %.0f) rotate(-90)\"", kHeight / 2).c_str());
    for (double v : x.ticks()) {
        out +=
            format("<path d=\"M%.1f %.1fV%.1f\" stroke=\"#e4e4e4\"/>\n", x.place(v), kTop, kHeight - kBottom);
        text(x.place(v), kHeight - kBottom + 18, "middle", format("%g", v));
    }
    for (double v : y.ticks()) {
        out +=
            format("<path d=\"M%.1f %.1fH%.1f\" stroke=\"#e4e4e4\"/>\n", kLeft, y.place(v), kWidth - kRight);
        text(kLeft - 8, y.place(v) + 4, "end", format("%g", v));
    }

    // The fronts
    double signX = plot.lessIsBetterX ? 1 : -1, signY = plot.lessIsBetterY ? 1 : -1;
    auto drawFront = [&](int series, const char *colour) { // -1: of all
        auto counts = [&](const PlotPoint &p) { return series < 0 || p.series == series; };
        std::vector<PlotPoint> front;
        for (auto &p : plot.points)
            if (counts(p) && std::none_of(plot.points.begin(), plot.points.end(), [&](const PlotPoint &q) {
                    double dx = (q.x - p.x) * signX, dy = (q.y - p.y) * signY;
                    return counts(q) && dx <= 0 && dy <= 0 && (dx < 0 || dy < 0);
                }))
                front.push_back(p);
        std::sort(front.begin(), front.end(), [](auto &a, auto &b) { return a.x < b.x; });
        std::string path;
        for (auto &p : front)
            path += format("%s%.1f %.1f", path.empty() ? "M" : "L", x.place(p.x), y.place(p.y));
        out +=
            "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-dasharray=\"4 3\"/>\n";
    };
    if (plot.frontOfEach)
        for (int i = 0; i < (int)plot.series.size(); ++i) drawFront(i, kColours[i % kColourCount]);
    else
        drawFront(-1, "#999");

    for (auto &p : plot.points) {
        const char *colour = kColours[p.series % kColourCount];
        out += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%d\" fill=\"%s\"%s><title>", x.place(p.x),
                      y.place(p.y), p.shipped ? 6 : 4, colour,
                      p.shipped ? " stroke=\"black\" stroke-width=\"2\"" : "") +
               escaped(p.name) + "</title></circle>\n";
        if (p.shipped) text(x.place(p.x) + 9, y.place(p.y) - 7, "start", p.name, " font-weight=\"bold\"");
    }
    for (size_t i = 0; i < plot.series.size(); ++i) {
        // In the corner that no front comes near
        double at =
            16 * (double)i +
            (plot.lessIsBetterY ? kTop + 14 : kHeight - kBottom + 6 - 16 * (double)plot.series.size());
        out += format("<circle cx=\"%.0f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", kWidth - kRight - 150,
                      at - 4, kColours[i % kColourCount]);
        text(kWidth - kRight - 140, at, "start", plot.series[i]);
    }
    return out + "</svg>\n";
}
