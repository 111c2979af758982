// SPDX-License-Identifier: Apache-2.0
#include "tools/povray_table.h"

#include "importers/pov/declared.h"
#include "tools/values.h"
#include "tools/verbs.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fmt/format.h>
#include <iterator>

namespace alidade {

namespace {

/// Where `Debug_File=on` writes to. Source   POV-Ray 3.7 reference, 3.2.7.2 "Directing Text Streams to Files".
constexpr const char* kDefaultMessageFiles[kMessageStreams] = {"ALLTEXT.OUT", "DEBUG.OUT", "FATAL.OUT", "RENDER.OUT", "STATS.OUT", "WARNING.OUT"};

/// What a word says that has been taken.
constexpr const char* kTaken = "";

constexpr int kMostPixels = 65536;
constexpr double kMostNumber = 1e30, kMostFrames = 1e9;

/// A word is told of once.
void tell(PovrayRequest& r, std::string note) {
    if (std::find(r.notes.begin(), r.notes.end(), note) == r.notes.end()) r.notes.push_back(std::move(note));
}

/// A whole number of these; a fraction is cut, as POV-Ray does.
std::optional<int> whole_number(PovrayRequest& r, const PovrayWord& w, int low, int high) {
    const auto x = parse_number(w.value, low);
    if (!x || !(*x < double(high) + 1) || w.value.find_first_not_of("+-.0123456789") != std::string::npos) return std::nullopt;   // POV-Ray reads no exponents here
    const int n = int(*x);
    if (*x != n) tell(r, fmt::format("{} is taken as {}", w.value, n));
    return n;
}

template <int PovrayRequest::* Member, int Low, int High> std::string integer(PovrayRequest& r, const PovrayWord& w) {
    const auto n = whole_number(r, w, Low, High);
    return n ? (r.*Member = *n, kTaken) : fmt::format("a whole number from {} to {}, without an exponent", Low, High);
}

enum class End { first, last };

/// A row or column, counted from 1, or a share of the picture: a last one is beyond 0.
template <double PovrayRequest::* Member, End Which> std::string edge(PovrayRequest& r, const PovrayWord& w) {
    const auto x = parse_number(w.value, 0, kMostPixels);
    if (x && (*x > 0 || Which == End::first)) return r.*Member = *x, kTaken;
    return fmt::format("a number {} to {}, or a share of the picture below 1", Which == End::first ? "from 0" : "above 0, up", kMostPixels);
}

template <double PovrayRequest::* Member> std::string number(PovrayRequest& r, const PovrayWord& w) {
    const auto x = parse_number(w.value, -kMostNumber, kMostNumber);
    return x ? (r.*Member = *x, kTaken) : fmt::format("a number from {:g} to {:g}", -kMostNumber, kMostNumber);
}

/// The end of a subset of frames: its number, or below 1 a share of the animation.
template <double PovrayRequest::* Member> std::string frame(PovrayRequest& r, const PovrayWord& w) {
    const auto x = parse_number(w.value, -kMostFrames, kMostFrames);
    return x ? (r.*Member = *x, kTaken) : fmt::format("a number up to {:g}, or a share of the animation below 1", kMostFrames);
}

/// `+X`, `-X` or `Key=on`.
template <bool PovrayRequest::* Member> std::string flag(PovrayRequest& r, const PovrayWord& w) {
    const auto on = w.value.empty() ? std::optional(w.on) : truth(w.value);
    return on ? (r.*Member = *on, kTaken) : "on, true, yes or 1; off, false, no or 0";
}

/// `+X0.3`, `+X` or `-X`: a switch that may bring its number.
template <bool PovrayRequest::* Member, double PovrayRequest::* Number> std::string flag_with_number(PovrayRequest& r, const PovrayWord& w) {
    if (!w.value.empty() && truth(w.value)) return r.*Member = *truth(w.value), kTaken;
    r.*Member = w.on;
    if (w.value.empty()) return kTaken;
    const auto x = parse_number(w.value, 0);
    return x ? (r.*Number = *x, kTaken) : "on, off, or a number from 0";
}

/// Cut to what POV-Ray takes.
template <int PovrayRequest::* Member, int Low, int High> std::string clamped(PovrayRequest& r, const PovrayWord& w) {
    constexpr int kMost = 1 << 30;
    const auto n = whole_number(r, w, -kMost, kMost);
    return n ? (r.*Member = std::clamp(*n, Low, High), kTaken) : fmt::format("a whole number (from {} to {} it is taken as it is), without an exponent", Low, High);
}

std::string input(PovrayRequest& r, const PovrayWord& w) { return r.input = w.value, w.value.empty() ? "the name of a scene" : kTaken; }
std::string output(PovrayRequest& r, const PovrayWord& w) { return r.output = w.value, kTaken; }
std::string library(PovrayRequest& r, const PovrayWord& w) {
    if (!w.value.empty()) r.library_paths.push_back(w.value);
    return kTaken;
}
std::string header(PovrayRequest& r, const PovrayWord& w) { return r.header = w.value, kTaken; }
std::string declare(PovrayRequest& r, const PovrayWord& w) {
    if (!pov::parse_declared(w.value)) return "an identifier, = and a number that a float can hold";
    if (w.value.rfind("clock=", 0) == 0) tell(r, "Declare=clock changes nothing: the clock is what +K says");
    else r.declarations.push_back(w.value);
    return kTaken;
}

/// Known words that change no picture here.
std::string nothing(PovrayRequest&, const PovrayWord&) { return kTaken; }
template <const char* const& Sentence> std::string told(PovrayRequest& r, const PovrayWord& w) {
    if (w.on) tell(r, Sentence);
    return kTaken;
}
constexpr const char* kNoGray = "+FNg (Grayscale_Output): pictures are written in colour";
constexpr const char* kNoIni = "+GI (Create_Ini): no INI file is written";
constexpr const char* kNoCommands = "commands around frames are not run";

/// Of `N16` POV-Ray takes the letter here.
std::string file_type(PovrayRequest& r, const PovrayWord& w) {
    const std::string letter = w.value.substr(0, w.value.find_first_of("0123456789"));
    if (letter != w.value && w.value.substr(letter.size()) != "8") tell(r, fmt::format("Output_File_Type={}: its number is left out, as POV-Ray does: give Bits_Per_Color", w.value));
    return file_switch(r, {letter, r.to_file});
}

std::string version(PovrayRequest& r, const PovrayWord& w) {
    const auto x = parse_number(w.value, 0);
    return x ? (r.version = *x, kTaken) : "a number from 0";
}

std::string clock(PovrayRequest& r, const PovrayWord& w) { return r.clock_given = true, number<&PovrayRequest::clock>(r, w); }

/// `+GD`, `-GD`, `Debug_Console=on`: whether what the scene prints goes to stderr; what we say does in any case. `+GDname`: to a file, too; `-GDname`: only there.
template <MessageStream Stream> std::string message_switch(PovrayRequest& r, const PovrayWord& w) {
    const auto on = truth(w.value);
    if (!w.value.empty() && !on) r.message_files[size_t(Stream)] = w.value;
    if (Stream == MessageStream::all || Stream == MessageStream::debug) r.shows_scene_text = w.on && on.value_or(true);
    return kTaken;
}
template <MessageStream Stream> std::string message_file(PovrayRequest& r, const PovrayWord& w) {
    const auto on = truth(w.value);
    r.message_files[size_t(Stream)] = !on ? w.value : *on ? kDefaultMessageFiles[size_t(Stream)] : "";
    return kTaken;
}

std::string file_gamma(PovrayRequest& r, const PovrayWord& w) {
    r.file_gamma = std::nullopt;
    if (lower(w.value) == "srgb") return kTaken;
    const auto x = parse_number(w.value, 0);
    return x && *x > 0 ? (r.file_gamma = *x, kTaken) : "sRGB, or a number above 0";
}

/// The manual's order: every row is a word of POV-Ray.
constexpr PovrayRow kTable[] = {
    {"Width", "W", integer<&PovrayRequest::width, 1, kMostPixels>},
    {"Height", "H", integer<&PovrayRequest::height, 1, kMostPixels>},
    {"Input_File_Name", "I", input},
    {"Output_File_Name", "O", output},
    {"Output_To_File", "F", file_switch},
    {"Output_File_Type", "", file_type},
    {"Bits_Per_Color", "", integer<&PovrayRequest::bits, 1, 100>},
    {"Library_Path", "L", library},
    {"Declare", "", declare},
    {"Antialias", "A", flag_with_number<&PovrayRequest::antialias, &PovrayRequest::antialias_threshold>},
    {"Antialias_Threshold", "", number<&PovrayRequest::antialias_threshold>},
    {"Antialias_Gamma", "AG", number<&PovrayRequest::antialias_gamma>},
    {"Antialias_Depth", "R", clamped<&PovrayRequest::antialias_depth, 1, 9>},
    {"Sampling_Method", "AM", clamped<&PovrayRequest::sampling_method, 1, 2>},
    {"Jitter", "J", flag_with_number<&PovrayRequest::jitter, &PovrayRequest::jitter_amount>},
    {"Jitter_Amount", "", number<&PovrayRequest::jitter_amount>},
    {"Quality", "Q", clamped<&PovrayRequest::quality, 0, 9>},
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
    {"Initial_Frame", "KFI", clamped<&PovrayRequest::initial_frame, 0, 1 << 30>},
    {"Final_Frame", "KFF", clamped<&PovrayRequest::final_frame, 0, 1 << 30>},
    {"Frame_Step", "STP", clamped<&PovrayRequest::frame_step, 1, 1 << 30>},
    {"Cyclic_Animation", "KC", flag<&PovrayRequest::cyclic>},
    {"Subset_Start_Frame", "SF", frame<&PovrayRequest::subset_start>},
    {"Subset_End_Frame", "EF", frame<&PovrayRequest::subset_end>},
    {"Field_Render", "UF", nothing},
    {"Odd_Field", "UO", nothing},
    {"Start_Column", "SC", edge<&PovrayRequest::start_column, End::first>},
    {"End_Column", "EC", edge<&PovrayRequest::end_column, End::last>},
    {"Start_Row", "SR", edge<&PovrayRequest::start_row, End::first>},
    {"End_Row", "ER", edge<&PovrayRequest::end_row, End::last>},
    {"Output_Alpha", "UA", flag<&PovrayRequest::alpha>},
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
    {"Include_Header", "HI", header},
    {"Version", "MV", version},
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

}  // namespace

std::span<const PovrayRow> povray_table() { return kTable; }

bool takes_name(const PovrayRow& row) {
    const ApplyPovrayWord names[] = {input, output, library, header, told<kNoCommands>, message_file<MessageStream::all>, message_file<MessageStream::debug>, message_file<MessageStream::fatal>, message_file<MessageStream::render>,
                                     message_file<MessageStream::statistic>, message_file<MessageStream::warning>};
    return std::find(std::begin(names), std::end(names), row.apply) != std::end(names);
}

std::optional<bool> truth(const std::string& text) {
    const std::string t = lower(text);
    if (t == "on" || t == "true" || t == "yes" || t == "1") return true;
    if (t == "off" || t == "false" || t == "no" || t == "0") return false;
    return std::nullopt;
}

std::string file_switch(PovrayRequest& r, const PovrayWord& w) {
    r.to_file = w.on;
    if (w.value.empty()) return kTaken;
    const char type = char(std::toupper(static_cast<unsigned char>(w.value[0])));
    if (!std::strchr("NPETJSBCH", type)) return "one of N P E T J S B C H, with bits a colour behind it or without";
    r.file_type = type == 'S' ? 'N' : type == 'C' ? 'T' : type;
    std::string bits = w.value.substr(1);
    if (!bits.empty() && (bits[0] == 'g' || bits[0] == 'G')) bits.erase(0, 1), told<kNoGray>(r, w);
    if (bits.empty()) return kTaken;
    const auto n = parse_integer(bits, 1, 100);
    return n ? (r.bits = int(*n), kTaken) : "bits a colour from 1 to 100 behind its letter";
}

}  // namespace alidade
