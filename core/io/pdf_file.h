// A PDF file of pages that are drawn in millimetres. Internal to io.
#pragma once

#include "core/geometry/bezier.h"
#include "core/io/drawing_text.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

/// What is drawn on a page: mm, origin at its lower left, y up. Later strokes lie over earlier
/// ones.
class PdfPage
{
public:
    explicit PdfPage(const Vec2 &size, std::size_t length = 4000);

    const Vec2 &size() const { return m_size; }
    /// Of the strokes that follow. colour  0xRRGGBB; width  mm
    void pen(std::uint32_t colour, double width);
    /// Strokes that follow are broken, dash and gap of this length, mm; 0: they are not.
    /// begun  mm of dash and gap that lie before the first one's start
    void dashes(double length, double begun = 0.0);
    /// What is drawn until the end of it is moved by this, and seen within the box alone, which is
    /// in the page's own coordinates.
    void beginClip(const Vec2 &corner, const Vec2 &size, const Vec2 &shift);
    void endClip();

    void edge(const Vec2 &from, const Vec2 &to);
    void rectangle(const Vec2 &corner, const Vec2 &size);
    /// Curves that follow on each other.
    void curves(const std::vector<CubicBezier> &chain, bool isClosed);
    /// Helvetica, black. height  of its line, mm; text  what is not in Latin-1 is a question mark
    void text(const Vec2 &at, double height, const std::string &latin1);

    std::string take();

private:
    Vec2 m_size;
    DrawingText m_out;
};

/// Without a date, so that the same pages make the same bytes. Packed with deflate.
/// Source  ISO 32000-1:2008, Portable Document Format 1.7, sections 7.5 (file structure) and 8
/// (graphics); 14.11.2 and table 30 for pages beyond 200 inches (UserUnit).
std::string pdfBytes(std::vector<PdfPage> pages);

} // namespace fff::io
