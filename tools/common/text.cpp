#include "tools/common/text.h"

#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <map>

namespace common {

static void append(std::string &to, const char *format, va_list arguments) {
    va_list again;
    va_copy(again, arguments);
    int size = std::vsnprintf(nullptr, 0, format, again);
    va_end(again);
    if (size < 0) return;
    size_t before = to.size();
    to.resize(before + (size_t)size + 1); // with the final zero
    std::vsnprintf(&to[before], (size_t)size + 1, format, arguments);
    to.pop_back();
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

std::string counted(size_t count, const std::string &what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string shellWord(const std::string &word) {
    constexpr char kPlain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=+-@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

// Pairs by their mark: a letter, and the letter with the mark
static constexpr const char *kMarked[][2] = {
    {"\u0300", "AÀEÈIÌOÒUÙaàeèiìoòuùÜǛüǜNǸnǹЕЀИЍеѐиѝĒḔēḕŌṐōṑWẀwẁÂẦâầĂẰăằÊỀêềÔỒôồƠỜơờƯỪưừYỲyỳ"},
    {"\u0301", "AÁEÉIÍOÓUÚYÝaáeéiíoóuúyýCĆcćLĹlĺNŃnńRŔrŕSŚsśZŹzźÜǗüǘGǴgǵÅǺåǻÆǼæǽØǾøǿ¨΅ΑΆΕΈΗΉΙΊΟΌΥΎΩΏ"
               "ϊΐαάεέηήιίϋΰοόυύωώϒϓГЃКЌгѓкќÇḈçḉĒḖēḗÏḮïḯKḰkḱMḾmḿÕṌõṍŌṒōṓPṔpṕŨṸũṹWẂwẃÂẤâấĂẮăắÊẾêếÔỐôố"
               "ƠỚơớƯỨưứ"},
    {"\u0302", "AÂEÊIÎOÔUÛaâeêiîoôuûCĈcĉGĜgĝHĤhĥJĴjĵSŜsŝWŴwŵYŶyŷZẐzẑẠẬạậẸỆẹệỌỘọộ"},
    {"\u0303", "AÃNÑOÕaãnñoõIĨiĩUŨuũVṼvṽÂẪâẫĂẴăẵEẼeẽÊỄêễÔỖôỗƠỠơỡƯỮưữYỸyỹ"},
    {"\u0304", "AĀaāEĒeēIĪiīOŌoōUŪuūÜǕüǖÄǞäǟȦǠȧǡÆǢæǣǪǬǫǭÖȪöȫÕȬõȭȮȰȯȱYȲyȳИӢиӣУӮуӯGḠgḡḶḸḷḹṚṜṛṝ"},
    {"\u0306", "AĂaăEĔeĕGĞgğIĬiĭOŎoŏUŬuŭУЎИЙийуўЖӁжӂАӐаӑЕӖеӗȨḜȩḝẠẶạặ"},
    {"\u0307", "CĊcċEĖeėGĠgġIİZŻzżAȦaȧOȮoȯBḂbḃDḊdḋFḞfḟHḢhḣMṀmṁNṄnṅPṖpṗRṘrṙSṠsṡŚṤśṥŠṦšṧṢṨṣṩTṪtṫWẆwẇXẊ"
               "xẋYẎyẏſẛ"},
    {"\u0308", "AÄEËIÏOÖUÜaäeëiïoöuüyÿYŸΙΪΥΫιϊυϋϒϔЕЁІЇеёіїАӒаӓӘӚәӛЖӜжӝЗӞзӟИӤиӥОӦоӧӨӪөӫЭӬэӭУӰуӱЧӴчӵЫӸ"
               "ыӹHḦhḧÕṎõṏŪṺūṻWẄwẅXẌxẍtẗ"},
    {"\u0309", "AẢaảÂẨâẩĂẲăẳEẺeẻÊỂêểIỈiỉOỎoỏÔỔôổƠỞơởUỦuủƯỬưửYỶyỷ"},
    {"\u030a", "AÅaåUŮuůwẘyẙ"},
    {"\u030b", "OŐoőUŰuűУӲуӳ"},
    {"\u030c", "CČcčDĎdďEĚeěLĽlľNŇnňRŘrřSŠsšTŤtťZŽzžAǍaǎIǏiǐOǑoǒUǓuǔÜǙüǚGǦgǧKǨkǩƷǮʒǯjǰHȞhȟ"},
    {"\u030f", "AȀaȁEȄeȅIȈiȉOȌoȍRȐrȑUȔuȕѴѶѵѷ"},
    {"\u0311", "AȂaȃEȆeȇIȊiȋOȎoȏRȒrȓUȖuȗ"},
    {"\u031b", "OƠoơUƯuư"},
    {"\u0323", "BḄbḅDḌdḍHḤhḥKḲkḳLḶlḷMṂmṃNṆnṇRṚrṛSṢsṣTṬtṭVṾvṿWẈwẉZẒzẓAẠaạEẸeẹIỊiịOỌoọƠỢơợUỤuụƯỰưựYỴyỵ"},
    {"\u0324", "UṲuṳ"},
    {"\u0325", "AḀaḁ"},
    {"\u0326", "SȘsșTȚtț"},
    {"\u0327", "CÇcçGĢgģKĶkķLĻlļNŅnņRŖrŗSŞsşTŢtţEȨeȩDḐdḑHḨhḩ"},
    {"\u0328", "AĄaąEĘeęIĮiįUŲuųOǪoǫ"},
    {"\u032d", "DḒdḓEḘeḙLḼlḽNṊnṋTṰtṱUṶuṷ"},
    {"\u032e", "HḪhḫ"},
    {"\u0330", "EḚeḛIḬiḭUṴuṵ"},
    {"\u0331", "BḆbḇDḎdḏKḴkḵLḺlḻNṈnṉRṞrṟTṮtṯZẔzẕhẖ"},
    {"\u3099", "かがきぎくぐけげこごさざしじすずせぜそぞただちぢつづてでとどはばひびふぶへべほぼうゔ"
               "ゝゞカガキギクグケゲコゴサザシジスズセゼソゾタダチヂツヅテデトドハバヒビフブヘベホボ"
               "ウヴワヷヰヸヱヹヲヺヽヾ"},
    {"\u309a", "はぱひぴふぷへぺほぽハパヒピフプヘペホポ"},
};

// The size of the character that begins at `at`, in bytes of UTF-8.
static size_t characterSize(const std::string &text, size_t at) {
    size_t size = 1;
    while (at + size < text.size() && ((uint8_t)text[at + size] & 0xc0) == 0x80) ++size;
    return size;
}

// A Korean syllable as its letters; empty for any other character.
static std::string koreanLetters(const std::string &c) {
    if (c.size() != 3) return "";
    const int syllable =
        (((uint8_t)c[0] & 15) << 12 | ((uint8_t)c[1] & 63) << 6 | ((uint8_t)c[2] & 63)) - 0xac00;
    std::string letters;
    if (syllable < 0 || syllable >= 19 * 588) return letters;
    for (int letter : {0x1100 + syllable / 588, 0x1161 + syllable % 588 / 28, 0x11a7 + syllable % 28})
        if (letter != 0x11a7)
            letters += {(char)0xe1, (char)(0x80 | (letter >> 6 & 63)), (char)(0x80 | (letter & 63))};
    return letters;
}

std::string decomposed(const std::string &text) {
    static const auto parts = [] {
        std::map<std::string, std::pair<std::string, std::string>> all;
        for (const auto &[mark, pairs] : kMarked)
            for (std::string rest = pairs; !rest.empty();) {
                const size_t first = characterSize(rest, 0), both = first + characterSize(rest, first);
                all[rest.substr(first, both - first)] = {rest.substr(0, first), mark};
                rest.erase(0, both);
            }
        return all;
    }();
    std::string to;
    for (size_t i = 0, size; i < text.size(); i += size) {
        size = characterSize(text, i);
        std::string letter = text.substr(i, size), marks = koreanLetters(letter);
        if (!marks.empty()) letter.clear();
        for (auto found = parts.find(letter); found != parts.end(); found = parts.find(letter))
            marks = found->second.second + marks, letter = found->second.first;
        to += letter + marks;
    }
    return to;
}

std::string htmlText(const std::string &text) {
    std::string escaped;
    for (char c : text) switch (c) {
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '&':
            escaped += "&amp;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += c;
        }
    return escaped;
}

} // namespace common
