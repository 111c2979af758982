// SPDX-License-Identifier: Apache-2.0
/// The image module: OpenImageIO behind core/image_module/abi.h. It stands in a library of its own because OpenImageIO pulls in some 260 others.
#include "core/image_module/abi.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string_view>
#include <vector>

namespace {

int refuse(AlidadeImageCall* call, const std::string& why) {
    std::snprintf(call->error, sizeof call->error, "%s", why.empty() ? "unknown error" : why.c_str());
    return 0;
}

uint32_t bits_of(OIIO::TypeDesc type) {
    if (type == OIIO::TypeDesc::UINT8) return 8;
    if (type == OIIO::TypeDesc::UINT16) return 16;
    return 0;
}

/// OpenImageIO 2.4 multiplies WebP's alpha into its encoded colour, whatever the configuration says: this takes it out again, as far as 8 bits kept it.
void divide_by_alpha(float* pixels, size_t count) {
    for (float* p = pixels; p != pixels + 4 * count; p += 4)
        for (int c = 0; c < 3 && p[3] > 0; ++c) p[c] = std::min(1.0f, std::round(p[c] / p[3] * 255) / 255);
}

/// Are the file's colours multiplied by its alpha? OpenImageIO gives what a TIFF file has, and says which it was.
bool is_associated_tiff(const char* format, const OIIO::ImageSpec& spec) {
    return format == std::string_view("tiff") && spec.alpha_channel == spec.nchannels - 1 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
}

/// Alpha is the last channel.
void make_straight(float* pixels, size_t count, int channels) {
    for (float* p = pixels; p != pixels + size_t(channels) * count; p += channels)
        for (int c = 0; c + 1 < channels && p[channels - 1] > 0; ++c) p[c] /= p[channels - 1];
}

/// OpenImageIO makes k * (1 / levels) of an integer k, other codecs k / levels: the same file in two formats would differ in the last digit.
void round_to(float* pixels, size_t count, uint32_t bits) {
    const double levels = double((1u << bits) - 1);
    for (size_t i = 0; i < count; ++i) pixels[i] = float(std::round(double(pixels[i]) * levels) / levels);
}

/// Asked of a second reader: going on and back again would read the first page twice.
uint32_t has_more_pages(const char* format, const void* bytes, size_t size) {
    if (format != std::string_view("tiff")) return 0;   // GIF and PSD count frames and layers as pages
    OIIO::Filesystem::IOMemReader proxy(const_cast<void*>(bytes), size);
    const auto input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    const bool more = input && input->set_ioproxy(&proxy) && input->open("memory.tiff", spec, OIIO::ImageSpec()) && input->seek_subimage(1, 0);
    if (input) input->close();
    return more;
}

int decode_with(OIIO::ImageInput& input, const char* format, const void* bytes, size_t size, AlidadeImageCall* call) {
    OIIO::Filesystem::IOMemReader proxy(const_cast<void*>(bytes), size);
    OIIO::ImageSpec config, spec;
    config.attribute("oiio:UnassociatedAlpha", 1);   // otherwise alpha is multiplied into the colour
    // In 2.4 ImageInput::open(name, config, proxy) fails; the proxy set first and then opened with a configuration works.
    if (!input.set_ioproxy(&proxy) || !input.open(std::string("memory.") + format, spec, config)) return refuse(call, input.geterror());
    if (spec.depth > 1) return refuse(call, "volumes are not supported");

    std::vector<const char*> names;
    for (const std::string& name : spec.channelnames) names.push_back(name.c_str());
    if (spec.nchannels == 1) names = {"Y"};
    const AlidadeImageInfo info{uint32_t(spec.width), uint32_t(spec.height), uint32_t(names.size()), bits_of(spec.format), names.data(),
                                has_more_pages(format, bytes, size), uint32_t(spec.get_int_attribute("Orientation", 1))};
    float* pixels = call->allocate(call, &info);
    if (!pixels) return 0;
    const bool complete = input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels);
    if (!complete || input.has_error()) return refuse(call, input.geterror());
    const size_t pixel_count = size_t(spec.width) * size_t(spec.height);
    if (info.bits > 0) round_to(pixels, pixel_count * size_t(spec.nchannels), info.bits);
    if (info.bits > 0 && is_associated_tiff(format, spec)) make_straight(pixels, pixel_count, spec.nchannels);   // of floats, colours are expected to be multiplied
    if (format == std::string_view("webp") && spec.nchannels == 4) divide_by_alpha(pixels, pixel_count);
    return 1;
}

int decode(const char* format, const void* bytes, size_t size, AlidadeImageCall* call) try {
    const auto input = OIIO::ImageInput::create(format);
    if (!input) return refuse(call, OIIO::geterror());
    const int done = decode_with(*input, format, bytes, size, call);
    input->close();
    return done;
} catch (const std::exception& e) {
    return refuse(call, e.what());
}

int encode(const char* format, const AlidadeImageInfo* info, const void* pixels, AlidadeImageCall* call) try {
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) return refuse(call, OIIO::geterror());
    OIIO::Filesystem::IOVecOutput proxy;
    const OIIO::TypeDesc type = info->bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(int(info->width), int(info->height), int(info->channels), type);
    spec.channelnames.assign(info->names, info->names + info->channels);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("DateTime", "1970:01:01 00:00:00");   // TIFF would take the present: the same picture must give the same bytes
    spec.attribute("jpeg:subsampling", "4:4:4");         // else four pixels share a colour: at 98 % quality that error is by far the largest
    if (!output->set_ioproxy(&proxy) || !output->open(std::string("memory.") + format, spec) || !output->write_image(type, pixels) || !output->close())
        return refuse(call, output->geterror());
    return call->write(call, proxy.buffer().data(), proxy.buffer().size());
} catch (const std::exception& e) {
    return refuse(call, e.what());
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const AlidadeImageModule* alidade_image_module() {
    static const AlidadeImageModule module{ALIDADE_IMAGE_ABI, decode, encode};
    return &module;
}
