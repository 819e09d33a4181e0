// SPDX-License-Identifier: MIT
#include "io/pictures/raster.h"

#include "io/byte_order.h"
#include "io/deflate.h"
#include "io/pictures/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <zlib.h>

namespace polydec {

namespace {

/// PNG has numbers of four bytes.
std::string number(unsigned long value) {
    return bytes_of(static_cast<std::uint32_t>(value), std::endian::big);
}

const Bytef* bytes_in(const std::string& text) {
    return reinterpret_cast<const Bytef*>(text.data());
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string text = type + data;
    return number(data.size()) + text + number(crc32_z(0, bytes_in(text), text.size()));
}

double distance(double x, double y, const SvgPoint& a, const SvgPoint& b) {
    const double dx = b[0] - a[0], dy = b[1] - a[1], squared = dx * dx + dy * dy;
    const double t = squared > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / squared : 0;
    const double part = std::clamp(t, 0.0, 1.0);
    return std::hypot(x - a[0] - part * dx, y - a[1] - part * dy);
}

/// The first of the pixels from 0 to `end` - 1 that may be touched, or the one after the last.
int clipped(double place, int end) {
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(end)));
}

} // namespace

Raster::Raster(int width, int height, Color ground)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), ground) {}

void Raster::stroke(SvgPoint from, SvgPoint to, double width, Color color) {
    const double reach = width / 2 + 1;
    const int left = clipped(std::min(from[0], to[0]) - reach, width_);
    const int right = clipped(std::max(from[0], to[0]) + reach + 1, width_);
    const int top = clipped(std::min(from[1], to[1]) - reach, height_);
    const int bottom = clipped(std::max(from[1], to[1]) + reach + 1, height_);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const double d = distance(x + 0.5, y + 0.5, from, to);
            const double cover = std::clamp(width / 2 + 0.5 - d, 0.0, 1.0);
            Color& pixel = pixels_[place(x, y)];
            for (std::size_t i = 0; i < 3; ++i)
                pixel[i] = static_cast<std::uint8_t>(
                    std::lround(pixel[i] + cover * (color[i] - pixel[i])));
        }
}

void Raster::fill(const SvgBox& box, Color color) {
    const int right = clipped(std::ceil(box.right - 0.5), width_);
    const int bottom = clipped(std::ceil(box.bottom - 0.5), height_);
    for (int y = clipped(std::ceil(box.top - 0.5), height_); y < bottom; ++y)
        for (int x = clipped(std::ceil(box.left - 0.5), width_); x < right; ++x)
            set(x, y, color);
}

void Raster::text(SvgPoint at, std::string_view text, double size, SvgAnchor anchor, Color color) {
    const double advance = svg_text_width("m", size), width = svg_text_width(text, size);
    const double across = 0.1 * size, up = 0.12 * size, thick = 0.085 * size;
    double x = at[0] - (anchor == SvgAnchor::end      ? width
                        : anchor == SvgAnchor::middle ? width / 2
                                                      : 0);
    for (const char character : text) {
        if ((static_cast<unsigned char>(character) & 0xC0U) == 0x80U)
            continue; // inside a character
        const std::string_view strokes = glyph(character);
        const auto point = [&](std::size_t i) {
            return SvgPoint{x + across * (strokes[i] - '0' + 0.9),
                            at[1] - up * (strokes[i + 1] - '2')};
        };
        for (std::size_t i = 0; i + 3 < strokes.size(); i += 2) {
            if (strokes[i + 2] == ' ') {
                ++i; // now at the last digit of the stroke
                continue;
            }
            stroke(point(i), point(i + 2), thick, color);
        }
        x += advance;
    }
}

void Raster::draw(const SvgShape& shape) {
    if (const auto* const line = std::get_if<SvgPolyline>(&shape))
        for (std::size_t i = 0; i + 1 < line->points.size(); ++i)
            stroke(line->points[i], line->points[i + 1], line->style.width,
                   color_of(line->style.stroke));
    if (const auto* const box = std::get_if<SvgPolygon>(&shape)) {
        const SvgPoint &start = box->points[0], &end = box->points[2];
        fill({start[0], start[1], end[0], end[1]}, color_of(box->style.fill));
    }
    if (const auto* const label = std::get_if<SvgText>(&shape))
        text(label->at, label->text, label->size, label->anchor, color_of(label->color));
}

Raster Raster::reduced(int factor) const {
    Raster result(width_ / factor, height_ / factor);
    const int count = factor * factor;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(pixels_.data());
    const std::size_t length = 3 * place(0, 1), step = 3 * static_cast<std::size_t>(factor);
    auto* pixel = reinterpret_cast<std::uint8_t*>(result.pixels_.data());
    for (int y = 0; y < result.height_; ++y)
        for (int x = 0; x < result.width_; ++x)
            for (int color = 0; color < 3; ++color) {
                int sum = count / 2;
                const auto* row = bytes + 3 * place(factor * x, factor * y) + color;
                for (int i = 0; i < factor; ++i, row += length)
                    for (std::size_t j = 0; j < step; j += 3)
                        sum += row[j];
                *pixel++ = static_cast<std::uint8_t>(sum / count);
            }
    return result;
}

std::string Raster::to_png() const {
    constexpr char up = 2; // each row is its difference from the row above
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(pixels_.data());
    const std::size_t length = 3 * place(0, 1);
    std::vector<std::uint8_t> above(length);
    std::string rows(place(0, height_) * 3 + static_cast<std::size_t>(height_), up);
    auto row = rows.begin();
    for (int y = 0; y < height_; ++y, bytes += length) {
        row = std::transform(
            bytes, bytes + length, above.begin(), row + 1,
            [](std::uint8_t own, std::uint8_t other) { return static_cast<char>(own - other); });
        above.assign(bytes, bytes + length);
    }
    const std::string header =
        number(width_) + number(height_) + std::string("\x08\x02\x00\x00\x00", 5);
    const std::string stream =
        "\x78\x9c" + deflate(rows) + number(adler32_z(1, bytes_in(rows), rows.size()));
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stream) + chunk("IEND", "");
}

} // namespace polydec
