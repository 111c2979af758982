// SPDX-License-Identifier: Apache-2.0
/// Pictures beside the file, and the pigments that show them.
#pragma once

#include "core/image.h"
#include "exporters/output_files.h"
#include "exporters/pov/picture_edges.h"
#include "exporters/pov/sdl.h"
#include "exporters/surfaces.h"

#include <functional>
#include <map>
#include <optional>
#include <tuple>

namespace alidade::pov_export {

/// What becomes of a picture's alpha. POV-Ray takes it for transparency whether it is asked for or not.
enum class PictureAlpha { kept, removed };

/// Pictures are written as they are, but where POV-Ray would show them otherwise: it cannot multiply a picture by a colour, nor ignore its alpha, nor clamp or
/// mirror it at its edges, it reads fewer formats, and some files not as they are. Then a PNG file is made.
class ImageWriter {
  public:
    ImageWriter(const Scene& scene, Sdl& sdl, OutputFiles& files, Losses& losses) : scene_(scene), sdl_(sdl), files_(files), losses_(losses) {}

    /// `uv_mapping image_map { }` of the picture times `tint`, in the space of its texture coordinates. `transmit`: of all of it. False, and nothing
    /// written, if the picture cannot be read or placed.
    bool map(const ImageSignal& image, const Vec4& tint = Vec4(1), PictureAlpha alpha = PictureAlpha::kept, double transmit = 0);
    /// The same without its alpha, within what is in the space of the picture `outer` already.
    bool map_within(const ImageSignal& outer, const ImageSignal& image, const Vec4& tint, double transmit = 0);
    /// `uv_mapping image_pattern { }`: a pattern whose value is what passes, 1 - alpha. False, and nothing written, if the picture cannot be read.
    bool alpha_pattern(const ImageSignal& image);
    /// What moves a pattern, behind all that it has, to where the texture coordinates look the picture up.
    void place(const ImageSignal& image);
    bool has_alpha(const ImageSignal& image);
    /// It is looked up beyond its edges, and repeated there although it should be clamped or mirrored.
    bool loses_edges(const ImageSignal& image) { return !edges(image).edges.exact; }
    /// The mean of one channel; 1 if the picture cannot be read.
    double mean(const ImageSignal& image, int channel, Encoding encoding = Encoding::linear);
    /// The block `word { }` of a picture in space: image_map, image_pattern, bump_map or material_map, which `more` ends. False, and nothing written, if it cannot be read.
    bool pattern(const std::string& word, const PatternPicture& picture, const std::function<void()>& more = nullptr);
    /// `image_map { }` of a picture that is no texture, around a sphere. False if it cannot be read.
    bool sky(ImageId image);

  private:
    struct Key {
        uint32_t image;
        std::array<double, 4> tint;
        PictureAlpha alpha;
        bool srgb;
        PictureEdges edges;
        friend auto operator<=>(const Key&, const Key&) = default;
    };
    struct File {
        std::string words;      ///< `png "name.png"`; empty: it cannot be read
        bool linear = false;
    };
    const std::string* encoded(ImageId id);
    const File& file(const ImageSignal& image, const Vec4& tint, PictureAlpha alpha);
    File make_file(const ImageSignal& image, const Vec4& tint, PictureAlpha alpha);
    void picture(const char* word, const File& file, const ImageSignal& image, const char* more, double transmit);
    bool tells_nothing(ImageId id);
    void picture_code(const std::string& word, const PatternPicture& p);
    struct Size {
        int width = 0, height = 0;
    };
    Size size(ImageId id);
    struct Framed {
        PictureEdges edges;
        Size within{1, 1};
    };
    const Framed& edges(const ImageSignal& image);
    Transform placement(const ImageSignal& image);
    void image_map(const File& file, const ImageSignal& image, double transmit);

    const Scene& scene_;
    Sdl& sdl_;
    OutputFiles& files_;
    Losses& losses_;
    std::map<uint32_t, tl::expected<std::string, std::string>> bytes_;
    std::map<Key, File> made_;
    std::map<std::tuple<uint32_t, int, Encoding>, double> means_;
    std::map<uint32_t, Size> sizes_;
    std::optional<std::map<Lookup, LookupRange>> ranges_;
    std::map<Lookup, Framed> edges_;
};

}  // namespace alidade::pov_export
