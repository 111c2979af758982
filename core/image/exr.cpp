// SPDX-License-Identifier: Apache-2.0
/// OpenEXR, by its C++ library and from memory: scan lines and tiles, half, float and integer channels. The channels of further parts
/// of a multi-part file come last, as "part.channel"; deep ones are left out.
#include "core/image/codec.h"

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace alidade::image {
namespace {

class MemoryInput : public Imf::IStream {
  public:
    explicit MemoryInput(std::span<const std::byte> bytes) : Imf::IStream("memory"), bytes_(bytes) {}

    bool read(char out[], int size) override {
        if (size < 0 || at_ > bytes_.size() || size_t(size) > bytes_.size() - at_) throw std::runtime_error("the file ends too early");
        std::memcpy(out, bytes_.data() + at_, size_t(size));
        at_ += size_t(size);
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override { at_ = position; }

  private:
    std::span<const std::byte> bytes_;
    uint64_t at_ = 0;
};

class MemoryOutput : public Imf::OStream {
  public:
    MemoryOutput() : Imf::OStream("memory") {}

    void write(const char data[], int size) override {
        if (bytes.size() < at_ + size_t(size)) bytes.resize(at_ + size_t(size));
        std::memcpy(bytes.data() + at_, data, size_t(size));
        at_ += size_t(size);
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t position) override { at_ = position; }

    Bytes bytes;

  private:
    uint64_t at_ = 0;
};

struct Window {
    int64_t x, y, width, height;

    explicit Window(const Imath::Box2i& box)
        : x(box.min.x), y(box.min.y), width(int64_t(box.max.x) - box.min.x + 1), height(int64_t(box.max.y) - box.min.y + 1) {}
    bool operator==(const Window&) const = default;
};

Result<void> check_window(const char* which, const Window& window, size_t channels, size_t file_bytes) {
    auto fits = check_size(uint64_t(std::max<int64_t>(window.width, 0)), uint64_t(std::max<int64_t>(window.height, 0)), channels, file_bytes);
    if (!fits) return tl::unexpected(fmt::format("{} window: {}", which, fits.error()));
    return {};
}

/// R, G, B, A (or Y, A) first, as every other format has them; then the rest as the file sorts it, by name.
Result<std::vector<std::string>> ordered_names(const Imf::ChannelList& channels) {
    std::vector<std::string> names;
    auto take = [&](const std::string& name) {
        if (channels.findChannel(name) && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const char* first : {"R", "G", "B", "Y", "A"}) take(first);
    for (auto c = channels.begin(); c != channels.end(); ++c) {
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
            return tl::unexpected(fmt::format("channel {} is subsampled, which is not supported", c.name()));
        take(c.name());
    }
    return names;
}

/// The part of `data` that the display window shows; what it shows beyond `data` is 0.
Picture crop(const Picture& data, const Window& data_window, const Window& display) {
    Picture shown(int(display.width), int(display.height), data.names);
    const int64_t left = std::max(data_window.x, display.x), right = std::min(data_window.x + data_window.width, display.x + display.width);
    const int64_t top = std::max(data_window.y, display.y), bottom = std::min(data_window.y + data_window.height, display.y + display.height);
    for (int64_t y = top; y < bottom && left < right; ++y)
        std::copy_n(data.at(int(left - data_window.x), int(y - data_window.y)), (right - left) * data.channels,
                    shown.at(int(left - display.x), int(y - display.y)));
    return shown;
}

void read_pixels(Imf::InputPart& part, const Window& window, Picture& picture) {
    const size_t pixel = sizeof(float) * size_t(picture.channels);
    Imf::FrameBuffer frame;
    for (int c = 0; c < picture.channels; ++c)
        frame.insert(picture.names[size_t(c)],
                     Imf::Slice::Make(Imf::FLOAT, picture.values.data() + c, Imath::V2i(int(window.x), int(window.y)), int64_t(window.width),
                                      int64_t(window.height), pixel, pixel * size_t(picture.width)));
    part.setFrameBuffer(frame);
    part.readPixels(int(window.y), int(window.y + window.height - 1));
}

bool is_deep(const Imf::Header& header) { return header.hasType() && Imf::isDeepData(header.type()); }

/// What the display window shows of a part, which all parts have in common. `before`: channels of the parts before it.
Result<Picture> decode_part(Imf::MultiPartInputFile& file, int number, size_t before, size_t file_bytes) {
    const Imf::Header& header = file.header(number);
    auto names = ordered_names(header.channels());
    if (!names) return tl::unexpected(names.error());
    const Window data(header.dataWindow()), display(header.displayWindow());
    if (auto fits = check_window("data", data, before + names->size(), file_bytes); !fits) return tl::unexpected(fits.error());
    if (auto fits = check_window("display", display, before + names->size(), file_bytes); !fits) return tl::unexpected(fits.error());
    Picture picture(int(data.width), int(data.height), std::move(*names));
    Imf::InputPart part(file, number);
    read_pixels(part, data, picture);
    return data == display ? std::move(picture) : crop(picture, data, display);
}

/// The channels of pictures of one size, which are gone afterwards.
Picture joined(std::vector<Picture> parts) {
    if (parts.size() == 1) return std::move(parts[0]);
    std::vector<std::string> names;
    for (const Picture& part : parts) names.insert(names.end(), part.names.begin(), part.names.end());
    Picture out(parts[0].width, parts[0].height, std::move(names));
    float* to = out.values.data();
    for (size_t p = 0; p < size_t(out.width) * size_t(out.height); ++p)
        for (const Picture& part : parts) to = std::copy_n(&part.values[p * size_t(part.channels)], part.channels, to);
    return out;
}

std::string part_name(const Imf::Header& header, int number) { return header.hasName() ? header.name() : fmt::format("part{}", number); }

bool is_within(const Window& a, const Window& b) { return a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height; }

/// Are there integers that a float rounds?
bool has_large_integers(const Imf::ChannelList& channels, const Picture& picture) {
    constexpr float kLargest = 0x1p24f;
    for (int c = 0; c < picture.channels; ++c) {
        const Imf::Channel* channel = channels.findChannel(picture.names[size_t(c)]);
        if (!channel || channel->type != Imf::UINT) continue;
        for (size_t i = size_t(c); i < picture.values.size(); i += size_t(picture.channels))
            if (picture.values[i] >= kLargest) return true;
    }
    return false;
}

/// What a file says of a part beyond what is read of it.
void tell_left_out(const Imf::Header& header, const Picture& read, std::vector<std::string>& left_out) {
    const auto add = [&](const char* clause) {
        if (std::find(left_out.begin(), left_out.end(), clause) == left_out.end()) left_out.push_back(clause);
    };
    if (!is_within(Window(header.dataWindow()), Window(header.displayWindow()))) add("pixels outside of its display window");
    const Imf::Chromaticities usual, own = Imf::hasChromaticities(header) ? Imf::chromaticities(header) : usual;
    constexpr float kSame = 1e-3f;
    const auto same = [](const Imath::V2f& a, const Imath::V2f& b) { return a.equalWithAbsError(b, kSame); };
    if (!same(own.red, usual.red) || !same(own.green, usual.green) || !same(own.blue, usual.blue) || !same(own.white, usual.white)) add("its chromaticities, which are not Rec. 709's");
    if (has_large_integers(header.channels(), read)) add("the last digits of integers from 16777216 on");
}

Result<Stored> decode(std::span<const std::byte> bytes) {
    MemoryInput input(bytes);
    Imf::MultiPartInputFile file(input, 0);
    if (is_deep(file.header(0))) return tl::unexpected(std::string("deep EXR pictures are not supported"));
    std::vector<Picture> parts;
    std::vector<std::string> left_out;
    size_t channels = 0, other_parts = 0;
    for (int i = 0; i < file.parts(); ++i) {
        if (is_deep(file.header(i))) {
            ++other_parts;
            continue;
        }
        auto part = decode_part(file, i, channels, bytes.size());
        if (!part) return tl::unexpected(part.error());
        if (i > 0 && (part->width != parts[0].width || part->height != parts[0].height)) {
            ++other_parts;
            continue;
        }
        tell_left_out(file.header(i), *part, left_out);
        for (std::string& name : part->names) name = i == 0 ? name : part_name(file.header(i), i) + "." + name;
        channels += part->names.size();
        parts.push_back(std::move(*part));
    }
    if (other_parts > 0) left_out.push_back(fmt::format("{} parts that are deep or of another size", other_parts));
    return Stored{joined(std::move(parts)), 0, 0, false, {}, std::move(left_out)};
}

Bytes encode(const Picture& picture) {
    Imf::Header header(picture.width, picture.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    const size_t pixel = sizeof(float) * size_t(picture.channels);
    Imf::FrameBuffer frame;
    for (int c = 0; c < picture.channels; ++c) {
        const std::string& name = picture.names[size_t(c)];
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        char* base = reinterpret_cast<char*>(const_cast<float*>(picture.values.data() + c));   // a slice serves reading and writing
        frame.insert(name, Imf::Slice(Imf::FLOAT, base, pixel, pixel * size_t(picture.width)));
    }
    MemoryOutput output;
    {
        Imf::OutputFile file(output, header, 0);   // its destructor writes the table of chunks
        file.setFrameBuffer(frame);
        file.writePixels(picture.height);
    }
    return std::move(output.bytes);
}

/// OpenEXR's messages name the stream first: Error reading pixel data from image file "memory". ...
std::string without_stream_name(std::string message) {
    for (size_t at; (at = message.find(" \"memory\"")) != std::string::npos;) message.erase(at, 9);
    return message;
}

}  // namespace

Result<Stored> decode_exr(std::span<const std::byte> bytes) try {
    return decode(bytes);
} catch (const std::bad_alloc&) {
    throw;
} catch (const std::exception& e) {
    return tl::unexpected("broken EXR: " + without_stream_name(e.what()));
}

Result<Bytes> encode_exr(const Picture& picture) try {
    const std::set<std::string> different(picture.names.begin(), picture.names.end());
    if (different.size() != picture.names.size()) return tl::unexpected(std::string("two channels have the same name"));
    return encode(picture);
} catch (const std::bad_alloc&) {
    throw;
} catch (const std::exception& e) {
    return tl::unexpected(without_stream_name(e.what()));
}

}  // namespace alidade::image
