// What words a widget paints, where and in which colours: a paint device that keeps nothing else.
#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QWidget>

#include <vector>

namespace fff::test {

struct PaintedWords
{
    QString text;
    QRectF box; // px of the widget
    QColor colour;
    QFont font;
};

class WordsEngine : public QPaintEngine
{
public:
    explicit WordsEngine(std::vector<PaintedWords> &words)
        : QPaintEngine(QPaintEngine::AllFeatures), m_words(words)
    {
    }

    bool begin(QPaintDevice *) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override {}
    void drawPath(const QPainterPath &) override {}
    void drawPolygon(const QPointF *, int, PolygonDrawMode) override {}
    void drawImage(const QRectF &, const QImage &, const QRectF &,
                   Qt::ImageConversionFlags) override
    {
    }
    void updateState(const QPaintEngineState &now) override
    {
        if (now.state() & DirtyPen)
            m_pen = now.pen();
        if (now.state() & DirtyTransform)
            m_transform = now.transform();
        if (now.state() & DirtyOpacity)
            m_opacity = now.opacity();
        if (now.state() & (DirtyClipRegion | DirtyClipPath | DirtyClipEnabled))
            m_clip = painter()->hasClipping() ? m_transform.mapRect(painter()->clipBoundingRect())
                                              : QRectF();
    }
    void drawTextItem(const QPointF &at, const QTextItem &item) override
    {
        QRectF box(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
        box = m_transform.mapRect(box);
        if (!m_clip.isNull())
            box &= m_clip;
        QColor colour = m_pen.color();
        colour.setAlphaF(static_cast<float>(colour.alphaF() * m_opacity));
        if (!item.text().trimmed().isEmpty() && !box.isEmpty())
            m_words.push_back({item.text(), box, colour, item.font()});
    }

private:
    std::vector<PaintedWords> &m_words;
    QPen m_pen;
    QTransform m_transform;
    double m_opacity = 1.0;
    QRectF m_clip;
};

class WordsDevice : public QPaintDevice
{
public:
    explicit WordsDevice(const QWidget &like) : m_like(like), m_engine(words) {}

    QPaintEngine *paintEngine() const override { return &m_engine; }

    std::vector<PaintedWords> words;

protected:
    int metric(PaintDeviceMetric what) const override
    {
        switch (what) {
        case PdmWidth:
            return m_like.width();
        case PdmHeight:
            return m_like.height();
        case PdmDepth:
            return 32;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        case PdmDpiX:
        case PdmPhysicalDpiX:
            return m_like.logicalDpiX();
        case PdmDpiY:
        case PdmPhysicalDpiY:
            return m_like.logicalDpiY();
        default:
            return 0;
        }
    }

private:
    const QWidget &m_like;
    mutable WordsEngine m_engine;
};

inline std::vector<PaintedWords> paintedWords(QWidget &widget)
{
    WordsDevice device(widget);
    widget.render(&device);
    return std::move(device.words);
}

} // namespace fff::test
