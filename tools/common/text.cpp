#include "tools/common/text.h"

#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

namespace common {

static void append(std::string &to, const char *format, va_list arguments) {
    char *text;
    int size = vasprintf(&text, format, arguments);
    if (size < 0) return;
    to.append(text, (size_t)size);
    std::free(text);
}

std::string format(const char *format, ...) {
    std::string text;
    va_list arguments;
    va_start(arguments, format);
    append(text, format, arguments);
    va_end(arguments);
    return text;
}

void append(std::string &to, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    append(to, format, arguments);
    va_end(arguments);
}

std::string thousands(double value) {
    std::string digits = format("%.0f", std::abs(value)), text = std::round(value) < 0 ? "-" : "";
    for (size_t i = 0; i < digits.size(); ++i) {
        if (i && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string counted(size_t count, const std::string &what, const std::string &plural) {
    return std::to_string(count) + " " +
           (count == 1        ? what
            : !plural.empty() ? plural
                              : what + (what.ends_with("ch") ? "es" : "s"));
}

std::string shellWord(const std::string &word) {
    constexpr char kPlain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=+-@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

// Words of a mark, and pairs of a letter without and with it
static constexpr char kMarked[] =
    "\u0300AÀEÈIÌOÒUÙaàeèiìoòuùÜǛüǜЕЀИЍеѐиѝÂẦâầĂẰăằÊỀêềÔỒôồƠỜơờƯỪưừYỲyỳ \u0301AÁEÉIÍOÓUÚYÝaáeéiíoóuúyýCĆ"
    "cćLĹlĺNŃnńRŔrŕSŚsśZŹzźÜǗüǘ¨΅ΑΆΕΈΗΉΙΊΟΌΥΎΩΏϊΐαάεέηήιίϋΰοόυύωώϒϓГЃКЌгѓкќÂẤâấĂẮăắÊẾêếÔỐôốƠỚơớƯỨưứ"
    " \u0302AÂEÊIÎOÔUÛaâeêiîoôuûCĈcĉGĜgĝHĤhĥJĴjĵSŜsŝWŴwŵYŶyŷẠẬạậẸỆẹệỌỘọộ \u0303AÃNÑOÕaãnñoõIĨiĩUŨuũÂẪâẫĂẴ"
    "ăẵEẼeẽÊỄêễÔỖôỗƠỠơỡƯỮưữYỸyỹ \u0304AĀaāEĒeēIĪiīOŌoōUŪuūÜǕüǖИӢиӣУӮуӯ \u0306AĂaăEĔeĕGĞgğIĬiĭOŎoŏUŬuŭУЎИЙ"
    "ийуўЖӁжӂАӐаӑЕӖеӗẠẶạặ \u0307CĊcċEĖeėGĠgġIİZŻzż \u0308AÄEËIÏOÖUÜaäeëiïoöuüyÿYŸΙΪΥΫιϊυϋϒϔЕЁІЇеёіїАӒаӓӘӚ"
    "әӛЖӜжӝЗӞзӟИӤиӥОӦоӧӨӪөӫЭӬэӭУӰуӱЧӴчӵЫӸыӹ \u0309AẢaảÂẨâẩĂẲăẳEẺeẻÊỂêểIỈiỉOỎoỏÔỔôổƠỞơởUỦuủƯỬưửYỶyỷ"
    " \u030aAÅaåUŮuů \u030bOŐoőUŰuűУӲуӳ \u030cCČcčDĎdďEĚeěLĽlľNŇnňRŘrřSŠsšTŤtťZŽzžAǍaǎIǏiǐOǑoǒUǓuǔÜǙüǚ"
    " \u030fѴѶѵѷ \u0323AẠaạEẸeẹIỊiịOỌoọƠỢơợUỤuụƯỰưựYỴyỵ \u0326SȘsșTȚtț \u0327CÇcçGĢgģKĶkķLĻlļNŅnņRŖrŗSŞsş"
    "TŢtţ \u0328AĄaąEĘeęIĮiįUŲuų \u3099かがきぎくぐけげこごさざしじすずせぜそぞただちぢつづてでとどはば"
    "ひびふぶへべほぼうゔゝゞカガキギクグケゲコゴサザシジスズセゼソゾタダチヂツヅテデトドハバヒビフブヘベ"
    "ホボウヴワヷヰヸヱヹヲヺヽヾ \u309aはぱひぴふぷへぺほぽハパヒピフプヘペホポ";

// Takes the first character of a text in UTF-8.
static std::string takeCharacter(std::string_view &text) {
    size_t size = 1;
    while (size < text.size() && ((uint8_t)text[size] & 0xc0) == 0x80) ++size;
    const std::string c(text.substr(0, size));
    text.remove_prefix(size);
    return c;
}

// All letters that can be divided, and their parts.
static std::map<std::string, std::string> dividedLetters() {
    std::map<std::string, std::string> all;
    std::istringstream words(kMarked);
    for (std::string word; words >> word;) {
        std::string_view rest = word;
        for (std::string mark = takeCharacter(rest), letter; !rest.empty();
             all[takeCharacter(rest)] = letter + mark)
            letter = takeCharacter(rest);
    }
    // Korean syllables
    auto utf8 = [](int c) {
        return std::string{(char)(0xe0 | c >> 12), (char)(0x80 | (c >> 6 & 63)), (char)(0x80 | (c & 63))};
    };
    for (int i = 0; i < 19 * 588; ++i)
        all[utf8(0xac00 + i)] =
            utf8(0x1100 + i / 588) + utf8(0x1161 + i % 588 / 28) + (i % 28 ? utf8(0x11a7 + i % 28) : "");
    return all;
}

std::string decomposed(std::string_view text) {
    static const auto all = dividedLetters();
    std::string to;
    while (!text.empty()) {
        const std::string c = takeCharacter(text);
        auto found = all.find(c);
        to += found == all.end() ? c : decomposed(found->second); // the letter may have another mark
    }
    return to;
}

std::string htmlText(const std::string &text) {
    static const std::map<char, std::string> kEscapes = {
        {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}};
    std::string escaped;
    for (char c : text) {
        auto found = kEscapes.find(c);
        escaped += found == kEscapes.end() ? std::string(1, c) : found->second;
    }
    return escaped;
}

} // namespace common
