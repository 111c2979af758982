// SPDX-License-Identifier: Apache-2.0
#include "stress/ray_file.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

namespace alidade {

static_assert(std::endian::native == std::endian::little, "the file's numbers are little-endian");

namespace {

constexpr std::string_view kMagic = "ALIDRAYS";
constexpr uint32_t kVersion = 1;
constexpr size_t kHeader = 24, kNumbers = 8;

struct Header {
    std::array<char, 8> magic{};
    uint32_t version = kVersion, number_bytes = 0;
    uint64_t count = 0;
};
static_assert(sizeof(Header) == kHeader);

std::array<double, kNumbers> numbers_of(const StressRay& ray) { return {ray.origin.x, ray.origin.y, ray.origin.z, ray.dir.x, ray.dir.y, ray.dir.z, ray.tmin, ray.tmax}; }

template <class R> void append(std::vector<std::byte>& out, const StressRay& ray) {
    for (const double number : numbers_of(ray)) {
        const auto bytes = std::bit_cast<std::array<std::byte, sizeof(R)>>(R(number));
        out.insert(out.end(), bytes.begin(), bytes.end());
    }
}

template <class R> StressRay ray_at(const std::byte* at) {
    std::array<R, kNumbers> n;
    std::memcpy(n.data(), at, sizeof n);
    return {Vec3(double(n[0]), double(n[1]), double(n[2])), Vec3(double(n[3]), double(n[4]), double(n[5])), double(n[6]), double(n[7])};
}

const char* why_no_ray(const StressRay& ray) {
    if (!is_finite(ray.origin)) return "its origin is not finite";
    if (!is_finite(ray.dir) || ray.dir == Vec3(0)) return "its direction is not finite, or zero";
    if (std::isnan(ray.tmin) || std::isnan(ray.tmax)) return "its tmin or tmax is not a number";
    return nullptr;
}

/// Why the header does not fit `size` bytes, or "".
std::string why_not(const Header& header, size_t size) {
    if (std::string_view(header.magic.data(), header.magic.size()) != kMagic) return fmt::format("byte 0: this is no file of rays: it does not begin with {}", kMagic);
    if (header.version != kVersion) return fmt::format("byte 8: version {} is not known; {} is", header.version, kVersion);
    if (header.number_bytes != 4 && header.number_bytes != 8) return fmt::format("byte 12: numbers of {} bytes: they have 4 or 8", header.number_bytes);
    const size_t ray = kNumbers * header.number_bytes, held = (size - kHeader) / ray;
    if (header.count > held) return fmt::format("byte 16: {} rays are told, but there are bytes for {}", header.count, held);
    if (header.count * ray + kHeader != size) return fmt::format("byte {}: there are {} bytes behind the last of {} rays", header.count * ray + kHeader, size - kHeader - header.count * ray, header.count);
    if (header.count == 0) return "byte 16: there are no rays";
    return {};
}

}  // namespace

std::vector<std::byte> encode_rays(std::span<const StressRay> rays, RayNumbers numbers) {
    Header header;
    std::copy(kMagic.begin(), kMagic.end(), header.magic.begin());
    header.number_bytes = uint32_t(numbers), header.count = rays.size();
    const auto head = std::bit_cast<std::array<std::byte, kHeader>>(header);
    std::vector<std::byte> out(head.begin(), head.end());
    out.reserve(kHeader + rays.size() * kNumbers * size_t(numbers));
    for (const StressRay& ray : rays) numbers == RayNumbers::float32 ? append<float>(out, ray) : append<double>(out, ray);
    return out;
}

tl::expected<std::vector<StressRay>, std::string> decode_rays(std::span<const std::byte> bytes) {
    if (bytes.size() < kHeader) return tl::unexpected(fmt::format("byte {}: the file ends within its header of {} bytes", bytes.size(), kHeader));
    Header header;
    std::memcpy(&header, bytes.data(), kHeader);
    if (std::string why = why_not(header, bytes.size()); !why.empty()) return tl::unexpected(std::move(why));
    std::vector<StressRay> rays;
    rays.reserve(header.count);
    for (size_t i = 0, at = kHeader; i < header.count; ++i, at += kNumbers * header.number_bytes) {
        rays.push_back(header.number_bytes == 4 ? ray_at<float>(&bytes[at]) : ray_at<double>(&bytes[at]));
        if (const char* why = why_no_ray(rays.back())) return tl::unexpected(fmt::format("byte {}: ray {}: {}", at, i, why));
    }
    return rays;
}

}  // namespace alidade
