#include "core/io/pdf_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace fff::io {

namespace {

constexpr double kPoints = 72.0 / 25.4;  // a mm
constexpr double kLargestSide = 14400.0; // points, that a reader knows
constexpr int kPenDecimals = 4;

std::string pdfNumber(double value, int decimals)
{
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

/// How many points a unit of the page is.
double unitOf(const Vec2 &size)
{
    return std::max(1.0, std::ceil(size.maxCoeff() * kPoints / kLargestSide));
}

std::string deflated(const std::string &bytes)
{
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string packed(size, '\0');
    // It fails for want of memory alone, and then throws before.
    compress2(reinterpret_cast<Bytef *>(packed.data()), &size,
              reinterpret_cast<const Bytef *>(bytes.data()), static_cast<uLong>(bytes.size()),
              Z_DEFAULT_COMPRESSION);
    packed.resize(size);
    return packed;
}

/// Objects in the order of their numbers, from 1.
class PdfObjects
{
public:
    PdfObjects() { m_bytes = "%PDF-1.6\n%\xE2\xE3\xCF\xD3\n"; }

    void add(const std::string &dictionary)
    {
        begin();
        m_bytes += dictionary + "\nendobj\n";
    }
    void addStream(const std::string &content)
    {
        begin();
        const std::string packed = deflated(content);
        m_bytes += "<< /Filter /FlateDecode /Length " + std::to_string(packed.size()) +
                   " >>\nstream\n" + packed + "\nendstream\nendobj\n";
    }
    std::string take(const std::string &trailer)
    {
        const std::string start = std::to_string(m_bytes.size());
        const std::string count = std::to_string(m_offsets.size() + 1);
        m_bytes += "xref\n0 " + count + "\n0000000000 65535 f \n";
        for (const std::size_t offset : m_offsets) {
            const std::string digits = std::to_string(offset);
            m_bytes += std::string(10 - std::min<std::size_t>(10, digits.size()), '0') + digits +
                       " 00000 n \n";
        }
        m_bytes +=
            "trailer\n<< /Size " + count + ' ' + trailer + " >>\nstartxref\n" + start + "\n%%EOF\n";
        return std::move(m_bytes);
    }

private:
    void begin()
    {
        m_offsets.push_back(m_bytes.size());
        m_bytes += std::to_string(m_offsets.size()) + " 0 obj\n";
    }

    std::string m_bytes;
    std::vector<std::size_t> m_offsets;
};

} // namespace

PdfPage::PdfPage(const Vec2 &size, std::size_t length) : m_size(size), m_out(length)
{
    const std::string scale = pdfNumber(kPoints / unitOf(size), 10);
    m_out << scale << " 0 0 " << scale << " 0 0 cm 1 j 1 J\n";
}

void PdfPage::pen(std::uint32_t colour, double width)
{
    constexpr double kFull = 255.0;
    for (const int shift : {16, 8, 0})
        m_out << pdfNumber((colour >> shift & 0xFF) / kFull, kPenDecimals) << " ";
    m_out << "RG " << pdfNumber(width, kPenDecimals) << " w\n";
}

void PdfPage::dashes(double length, double begun)
{
    if (length > 0.0)
        // Both told: some readers take a single length for all of the pattern where it is begun.
        m_out << "[" << length << ' ' << length << "] " << begun << " d\n";
    else
        m_out << "[] 0 d\n";
}

void PdfPage::beginClip(const Vec2 &corner, const Vec2 &size, const Vec2 &shift)
{
    m_out << "q " << corner.x() << " " << corner.y() << " " << size.x() << " " << size.y()
          << " re W n 1 0 0 1 " << shift.x() << " " << shift.y() << " cm\n";
}

void PdfPage::endClip()
{
    m_out << "Q\n";
}

void PdfPage::edge(const Vec2 &from, const Vec2 &to)
{
    m_out.addPoint<Decimals::Three>("", from);
    m_out.addPoint<Decimals::Three>(" m ", to);
    m_out << " l S\n";
}

void PdfPage::rectangle(const Vec2 &corner, const Vec2 &size)
{
    m_out << corner.x() << " " << corner.y() << " " << size.x() << " " << size.y() << " re S\n";
}

void PdfPage::curves(const std::vector<CubicBezier> &chain, bool isClosed)
{
    if (chain.empty())
        return;
    m_out.addPoint<Decimals::Three>("", chain.front().p0);
    m_out << " m";
    for (const CubicBezier &curve : chain) {
        constexpr double kStraight = 1e-5; // mm, well below what is written
        if (curve.isStraight(kStraight)) {
            m_out.addPoint<Decimals::Three>(" ", curve.p3);
            m_out << " l";
            continue;
        }
        for (const Vec2 &p : {curve.p1, curve.p2, curve.p3})
            m_out.addPoint<Decimals::Three>(" ", p);
        m_out << " c";
    }
    m_out << (isClosed ? " h S\n" : " S\n");
}

void PdfPage::text(const Vec2 &at, double height, const std::string &latin1)
{
    std::string safe;
    for (const char c : latin1) {
        if (c == '(' || c == ')' || c == '\\')
            safe += '\\';
        safe += c;
    }
    m_out << "BT /F1 " << height << " Tf " << at.x() << " " << at.y() << " Td (" << safe
          << ") Tj ET\n";
}

std::string PdfPage::take()
{
    return m_out.take();
}

std::string pdfBytes(std::vector<PdfPage> pages)
{
    constexpr std::size_t kFirstPage = 5; // object; its content is the next one
    PdfObjects objects;
    objects.add("<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>");
    std::string kids;
    for (std::size_t i = 0; i < pages.size(); ++i)
        kids += std::to_string(kFirstPage + 2 * i) + " 0 R ";
    objects.add("<< /Type /Pages /Kids [ " + kids + "] /Count " + std::to_string(pages.size()) +
                " >>");
    objects.add(
        "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>");
    objects.add("<< /Producer (FlatFitFab " FFF_VERSION ") >>");
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const double unit = unitOf(pages[i].size());
        const Vec2 size = pages[i].size() * kPoints / unit;
        objects.add("<< /Type /Page /Parent 2 0 R /MediaBox [ 0 0 " + pdfNumber(size.x(), 5) + ' ' +
                    pdfNumber(size.y(), 5) + " ]" +
                    (unit > 1.0 ? " /UserUnit " + pdfNumber(unit, 0) : std::string()) +
                    " /Resources << /Font << /F1 3 0 R >> >> /Contents " +
                    std::to_string(kFirstPage + 2 * i + 1) + " 0 R >>");
        objects.addStream(pages[i].take());
    }
    return objects.take("/Root 1 0 R /Info 4 0 R");
}

} // namespace fff::io
