// SPDX-License-Identifier: Apache-2.0
#include "tools/povray_words.h"

#include "tools/values.h"
#include "tools/verbs.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <string_view>

namespace alidade {

namespace {

/// A word's value, and whether it is switched on (+) or off (-).
struct Word {
    std::string value;
    bool on = true;
};

/// Where `Debug_File=on` writes to. Source   POV-Ray 3.7 reference, 3.2.7.2 "Directing Text Streams to Files".
constexpr const char* kDefaultMessageFiles[kMessageStreams] = {"ALLTEXT.OUT", "DEBUG.OUT", "FATAL.OUT", "RENDER.OUT", "STATS.OUT", "WARNING.OUT"};

using Apply = bool (*)(PovrayRequest&, const Word&);   // false: the value is none

struct Row {
    const char* key;       ///< of Key=Value
    const char* letters;   ///< of the switch, or ""
    Apply apply;
};

std::optional<bool> truth(const std::string& text) {
    const std::string t = lower(text);
    if (t == "on" || t == "true" || t == "yes" || t == "1") return true;
    if (t == "off" || t == "false" || t == "no" || t == "0") return false;
    return std::nullopt;
}

template <int PovrayRequest::* Member, int Low, int High> bool integer(PovrayRequest& r, const Word& w) {
    const auto n = parse_integer(w.value, Low, High);
    return n ? (r.*Member = int(*n), true) : false;
}

template <double PovrayRequest::* Member> bool number(PovrayRequest& r, const Word& w) {
    const auto x = parse_number(w.value, -1e30);
    return x ? (r.*Member = *x, true) : false;
}

template <std::optional<int> PovrayRequest::* Member> bool frame(PovrayRequest& r, const Word& w) {
    const auto n = parse_integer(w.value, 0, 1 << 30);
    return n ? (r.*Member = int(*n), true) : false;
}

/// `+X`, `-X` or `Key=on`.
template <bool PovrayRequest::* Member> bool flag(PovrayRequest& r, const Word& w) {
    const auto on = w.value.empty() ? std::optional(w.on) : truth(w.value);
    return on ? (r.*Member = *on, true) : false;
}

/// `+X0.3`, `+X` or `-X`: a switch that may bring its number.
template <bool PovrayRequest::* Member, double PovrayRequest::* Number> bool flag_with_number(PovrayRequest& r, const Word& w) {
    if (!w.value.empty() && truth(w.value)) return r.*Member = *truth(w.value), true;
    r.*Member = w.on;
    if (w.value.empty()) return true;
    const auto x = parse_number(w.value, 0);
    return x ? (r.*Number = *x, true) : false;
}

/// Cut to what POV-Ray takes.
bool antialias_depth(PovrayRequest& r, const Word& w) {
    const auto n = parse_integer(w.value, 0, 1 << 30);
    return n ? (r.antialias_depth = std::clamp(int(*n), 1, 9), true) : false;
}

bool input(PovrayRequest& r, const Word& w) { return r.input = w.value, !w.value.empty(); }
bool output(PovrayRequest& r, const Word& w) { return r.output = w.value, true; }
bool library(PovrayRequest& r, const Word& w) { return r.library_paths.push_back(w.value), !w.value.empty(); }
bool declare(PovrayRequest& r, const Word& w) { return r.declarations.push_back(w.value), w.value.find('=') != std::string::npos; }

/// Known words that change no picture here.
bool nothing(PovrayRequest&, const Word&) { return true; }
template <const char* const& Sentence> bool told(PovrayRequest& r, const Word& w) {
    if (w.on && std::find(r.notes.begin(), r.notes.end(), Sentence) == r.notes.end()) r.notes.emplace_back(Sentence);
    return true;
}
constexpr const char* kNoAlpha = "+UA (Output_Alpha): pictures have no alpha channel yet";
constexpr const char* kNoQuality = "+Q (Quality): pictures are always made in full quality";
constexpr const char* kNoField = "+UF (Field_Render): all rows are rendered";
constexpr const char* kNoGray = "+FNg (Grayscale_Output): pictures are written in colour";
constexpr const char* kNoFileGamma = "File_Gamma: pictures are encoded as sRGB";
constexpr const char* kNoIni = "+GI (Create_Ini): no INI file is written";
constexpr const char* kNoHeader = "+HI (Include_Header): nothing is included before the scene";
constexpr const char* kNoCommands = "commands around frames are not run";

/// `+F`, `+FN8`, `-F`: whether there is a file, its type and its bits.
bool file(PovrayRequest& r, const Word& w) {
    r.to_file = w.on;
    if (w.value.empty()) return true;
    const char type = char(std::toupper(static_cast<unsigned char>(w.value[0])));
    if (!std::strchr("NPETJSBCH", type)) return false;
    r.file_type = type == 'S' ? 'N' : type == 'C' ? 'T' : type;
    std::string bits = w.value.substr(1);
    if (!bits.empty() && (bits[0] == 'g' || bits[0] == 'G')) bits.erase(0, 1), told<kNoGray>(r, w);
    if (bits.empty()) return true;
    const auto n = parse_integer(bits, 1, 100);
    return n ? (r.bits = int(*n), true) : false;
}

bool file_type(PovrayRequest& r, const Word& w) { return file(r, {w.value, r.to_file}); }

bool clock(PovrayRequest& r, const Word& w) { return r.clock_given = true, number<&PovrayRequest::clock>(r, w); }

/// `+GD`, `-GD`, `Debug_Console=on`: what is said goes to stderr, all of it. `+GDname`: to a file, too.
template <MessageStream Stream> bool message_switch(PovrayRequest& r, const Word& w) {
    if (w.on && !w.value.empty() && !truth(w.value)) r.message_files[size_t(Stream)] = w.value;
    return true;
}
template <MessageStream Stream> bool message_file(PovrayRequest& r, const Word& w) {
    const auto on = truth(w.value);
    r.message_files[size_t(Stream)] = !on ? w.value : *on ? kDefaultMessageFiles[size_t(Stream)] : "";
    return true;
}

bool file_gamma(PovrayRequest& r, const Word& w) { return lower(w.value) == "srgb" || told<kNoFileGamma>(r, w); }

/// Below 9 POV-Ray leaves things out.
bool quality(PovrayRequest& r, const Word& w) {
    const auto n = parse_integer(w.value, 0, 11);
    return n && (*n >= 9 || told<kNoQuality>(r, w));
}

/// The manual's order: every row is a word of POV-Ray.
constexpr Row kTable[] = {
    {"Width", "W", integer<&PovrayRequest::width, 1, 65536>},
    {"Height", "H", integer<&PovrayRequest::height, 1, 65536>},
    {"Input_File_Name", "I", input},
    {"Output_File_Name", "O", output},
    {"Output_To_File", "F", file},
    {"Output_File_Type", "", file_type},
    {"Bits_Per_Color", "", integer<&PovrayRequest::bits, 1, 100>},
    {"Library_Path", "L", library},
    {"Declare", "", declare},
    {"Antialias", "A", flag_with_number<&PovrayRequest::antialias, &PovrayRequest::antialias_threshold>},
    {"Antialias_Threshold", "", number<&PovrayRequest::antialias_threshold>},
    {"Antialias_Gamma", "AG", number<&PovrayRequest::antialias_gamma>},
    {"Antialias_Depth", "R", antialias_depth},
    {"Sampling_Method", "AM", integer<&PovrayRequest::sampling_method, 1, 2>},
    {"Jitter", "J", flag_with_number<&PovrayRequest::jitter, &PovrayRequest::jitter_amount>},
    {"Jitter_Amount", "", number<&PovrayRequest::jitter_amount>},
    {"Quality", "Q", quality},
    {"Verbose", "V", flag<&PovrayRequest::verbose>},
    {"Display", "D", nothing},
    {"Video_Mode", "", nothing},
    {"Palette", "", nothing},
    {"Display_Gamma", "", nothing},
    {"File_Gamma", "", file_gamma},
    {"Pause_When_Done", "P", nothing},
    {"Test_Abort", "X", nothing},
    {"Test_Abort_Count", "", nothing},
    {"Clockless_Animation", "", nothing},
    {"Continue_Trace", "C", flag<&PovrayRequest::continued>},
    {"Create_Continue_Trace_Log", "", nothing},
    {"Clock", "K", clock},
    {"Initial_Clock", "KI", number<&PovrayRequest::initial_clock>},
    {"Final_Clock", "KF", number<&PovrayRequest::final_clock>},
    {"Initial_Frame", "KFI", integer<&PovrayRequest::initial_frame, 0, 1 << 30>},
    {"Final_Frame", "KFF", integer<&PovrayRequest::final_frame, 0, 1 << 30>},
    {"Frame_Step", "STP", integer<&PovrayRequest::frame_step, 1, 1 << 30>},
    {"Cyclic_Animation", "KC", flag<&PovrayRequest::cyclic>},
    {"Subset_Start_Frame", "SF", frame<&PovrayRequest::subset_start>},
    {"Subset_End_Frame", "EF", frame<&PovrayRequest::subset_end>},
    {"Field_Render", "UF", told<kNoField>},
    {"Odd_Field", "UO", nothing},
    {"Start_Column", "SC", number<&PovrayRequest::start_column>},
    {"End_Column", "EC", number<&PovrayRequest::end_column>},
    {"Start_Row", "SR", number<&PovrayRequest::start_row>},
    {"End_Row", "ER", number<&PovrayRequest::end_row>},
    {"Output_Alpha", "UA", told<kNoAlpha>},
    {"Work_Threads", "WT", integer<&PovrayRequest::threads, 0, 4096>},
    {"Render_Block_Size", "BS", nothing},
    {"Render_Block_Step", "", nothing},
    {"Render_Pattern", "RP", nothing},
    {"Bounding", "MB", nothing},
    {"Bounding_Threshold", "", nothing},
    {"Bounding_Method", "BM", nothing},
    {"BSP_MaxDepth", "", nothing},
    {"BSP_BaseAccess", "", nothing},
    {"BSP_ChildAccess", "", nothing},
    {"BSP_IsectCost", "", nothing},
    {"BSP_MissChance", "", nothing},
    {"Light_Buffer", "UL", nothing},
    {"Vista_Buffer", "UV", nothing},
    {"Draw_Vistas", "UD", nothing},
    {"Remove_Bounds", "UR", nothing},
    {"Split_Unions", "SU", nothing},
    {"Buffer_Output", "", nothing},
    {"Buffer_Size", "B", nothing},
    {"Max_Image_Buffer_Memory", "MI", nothing},
    {"Compression", "", nothing},
    {"Dither", "TH", nothing},
    {"Dither_Method", "", nothing},
    {"Grayscale_Output", "", told<kNoGray>},
    {"Include_Header", "HI", told<kNoHeader>},
    {"Version", "MV", nothing},
    {"Create_Ini", "GI", told<kNoIni>},
    {"Create_Histogram", "", nothing},
    {"Warning_Level", "WL", nothing},
    {"All_Console", "GA", message_switch<MessageStream::all>},
    {"Debug_Console", "GD", message_switch<MessageStream::debug>},
    {"Fatal_Console", "GF", message_switch<MessageStream::fatal>},
    {"Render_Console", "GR", message_switch<MessageStream::render>},
    {"Statistic_Console", "GS", message_switch<MessageStream::statistic>},
    {"Warning_Console", "GW", message_switch<MessageStream::warning>},
    {"All_File", "", message_file<MessageStream::all>},
    {"Debug_File", "", message_file<MessageStream::debug>},
    {"Fatal_File", "", message_file<MessageStream::fatal>},
    {"Render_File", "", message_file<MessageStream::render>},
    {"Statistic_File", "", message_file<MessageStream::statistic>},
    {"Warning_File", "", message_file<MessageStream::warning>},
    {"Radiosity_File_Name", "RF", nothing},
    {"Radiosity_From_File", "RFI", nothing},
    {"Radiosity_To_File", "RFO", nothing},
    {"Radiosity_Vain_Pretrace", "RVP", nothing},
    {"High_Reproducibility", "HR", nothing},
    {"Preview_Start_Size", "SP", nothing},
    {"Preview_End_Size", "EP", nothing},
    {"Real_Time_Raytracing", "RTR", nothing},
    {"Pre_Scene_Command", "", told<kNoCommands>},
    {"Post_Scene_Command", "", told<kNoCommands>},
    {"Pre_Frame_Command", "", told<kNoCommands>},
    {"Post_Frame_Command", "", told<kNoCommands>},
    {"User_Abort_Command", "", told<kNoCommands>},
    {"Fatal_Error_Command", "", told<kNoCommands>},
    {"Pre_Scene_Return", "", nothing},
    {"Post_Scene_Return", "", nothing},
    {"Pre_Frame_Return", "", nothing},
    {"Post_Frame_Return", "", nothing},
    {"User_Abort_Return", "", nothing},
    {"Fatal_Error_Return", "", nothing},
};

std::string unknown(const std::string& word) {
    std::vector<std::string> known;
    for (const Row& row : kTable) known.push_back(lower(row.key));
    std::string near = nearest(lower(word.substr(0, word.find('='))), known);
    for (const Row& row : kTable)
        if (!near.empty() && near == lower(row.key)) near = row.key;
    return fmt::format("'{}' is no word of POV-Ray{}", word, near.empty() ? "" : fmt::format("; did you mean '{}='?", near));
}

constexpr std::string_view kSeed = "--seed=";   // ours alone

/// One command line, with the INI files that it names.
class Reading {
  public:
    std::string take(const std::string& word) {
        if (word.empty()) return {};
        if (word.rfind(kSeed, 0) == 0) return take_seed(word);
        if (word[0] == '+' || word[0] == '-') return take_switch(word);
        const size_t equals = word.find('=');
        if (equals != std::string::npos) return take_key(word, equals);
        const std::string name = lower(word.substr(0, word.find('[')));
        if (std::filesystem::path(name).extension() == ".pov") return request.input = word, std::string();
        return take_ini(word);
    }

    /// What holds before all words.
    std::string take_defaults() {
        namespace fs = std::filesystem;
        const char *named = std::getenv("POVINI"), *home = std::getenv("HOME");
        std::vector<fs::path> places;
        if (named) places.emplace_back(named);
        places.emplace_back("povray.ini");
        if (home) places.push_back(fs::path(home) / ".povray/3.7/povray.ini");
        places.emplace_back("/etc/povray/3.7/povray.ini");
        for (const fs::path& place : places)
            if (fs::is_regular_file(place)) return take_ini(place.string());
        return {};
    }

    PovrayRequest request;

  private:
    std::string apply(const Row& row, const Word& value, const std::string& word) {
        if (row.apply(request, value)) return {};
        return fmt::format("'{}' has no value that {} can take", word, row.key);
    }

    std::string take_seed(const std::string& word) {
        const auto seed = parse_integer(word.substr(kSeed.size()), 0, std::numeric_limits<int64_t>::max());
        return seed ? (request.seed = uint64_t(*seed), std::string()) : fmt::format("'{}': {}", word, seed.error());
    }

    /// The row whose letters are the longest beginning of the word.
    std::string take_switch(const std::string& word) {
        const std::string text = lower(word.substr(1));
        const Row* best = nullptr;
        size_t length = 0;
        for (const Row& row : kTable) {
            const std::string letters = lower(row.letters);
            if (letters.size() > length && text.rfind(letters, 0) == 0) best = &row, length = letters.size();
        }
        if (!best) return unknown(word);
        return apply(*best, {word.substr(1 + length), word[0] == '+'}, word);
    }

    std::string take_key(const std::string& word, size_t equals) {
        const std::string key = lower(word.substr(0, equals));
        std::string value = word.substr(equals + 1);
        if (value.size() > 1 && (value[0] == '"' || value[0] == '\'') && value.back() == value[0]) value = value.substr(1, value.size() - 2);
        if (key == "include_ini") return take_ini(value);
        for (const Row& row : kTable) {
            if (key != lower(row.key)) continue;
            const bool switched = row.apply == static_cast<Apply>(file);   // the key's value says on or off
            const auto on = truth(value);
            return apply(row, switched ? Word{"", on.value_or(true)} : Word{value, on.value_or(true)}, word);
        }
        return unknown(word);
    }

    std::string take_ini(const std::string& word) {
        constexpr int kDeepest = 10;
        const size_t bracket = word.find('[');
        std::string path = word.substr(0, bracket);
        const std::string wanted = bracket == std::string::npos ? "" : lower(word.substr(bracket + 1, word.find(']', bracket) - bracket - 1));
        if (!std::filesystem::is_regular_file(path) && std::filesystem::is_regular_file(path + ".ini")) path += ".ini";
        std::ifstream in(path);
        if (!std::filesystem::is_regular_file(path) || !in) return unknown(word) + ", and no INI file of that name can be read";
        if (++depth_ > kDeepest) return fmt::format("INI files include one another more than {} deep", kDeepest);
        std::string section;
        for (std::string line; std::getline(in, line);) {
            if (const std::string wrong = take_line(line, section, wanted); !wrong.empty()) return fmt::format("{}: {}", path, wrong);
        }
        --depth_;
        return {};
    }

    /// `[section]`, `Key=Value`, or switches; `;` begins a comment. What stands before all sections always holds.
    std::string take_line(std::string line, std::string& section, const std::string& wanted) {
        line = line.substr(0, line.find(';'));
        const size_t first = line.find_first_not_of(" \t\r"), last = line.find_last_not_of(" \t\r");
        if (first == std::string::npos) return {};
        line = line.substr(first, last - first + 1);
        if (line[0] == '[') return section = lower(line.substr(1, line.find(']') - 1)), std::string();
        if (!section.empty() && section != wanted) return {};
        if (line[0] != '+' && line[0] != '-') {
            const size_t equals = line.find('=');
            if (equals == std::string::npos) return take(line);
            const auto trim = [](std::string s) {
                const size_t a = s.find_first_not_of(" \t"), b = s.find_last_not_of(" \t");
                return a == std::string::npos ? std::string() : s.substr(a, b - a + 1);
            };
            return take(trim(line.substr(0, equals)) + "=" + trim(line.substr(equals + 1)));
        }
        for (size_t at = 0; at < line.size();) {
            const size_t end = std::min(line.find_first_of(" \t", at), line.size());
            if (end > at)
                if (const std::string wrong = take(line.substr(at, end - at)); !wrong.empty()) return wrong;
            at = end + 1;
        }
        return {};
    }

    int depth_ = 0;
};

}  // namespace

tl::expected<PovrayRequest, std::string> parse_povray_words(const std::vector<std::string>& words) {
    Reading reading;
    if (std::string wrong = reading.take_defaults(); !wrong.empty()) return tl::unexpected(std::move(wrong));
    for (const std::string& word : words)
        if (std::string wrong = reading.take(word); !wrong.empty()) return tl::unexpected(std::move(wrong));
    if (reading.request.input.empty()) return tl::unexpected(std::string("no scene is named: +Iscene.pov"));
    if (reading.request.final_frame < reading.request.initial_frame) return tl::unexpected(std::string("the final frame comes before the initial one"));
    return std::move(reading.request);
}

}  // namespace alidade
