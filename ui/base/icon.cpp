#include "ui/base/icon.h"

#include "ui/base/theme.h"

#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>

#include <cmath>

namespace fff::ui {

namespace {

constexpr int kGrid = 24; // px of a mask at 1x

/// The mask in its own size or the next larger one, scaled to `pixels`.
QImage mask(const QString &name, int pixels)
{
    QString path = QStringLiteral(":/icons/%1.png").arg(name);
    for (int scale : {2, 3}) {
        if (pixels > kGrid * (scale - 1))
            path = QStringLiteral(":/icons/%1@%2x.png").arg(name).arg(scale);
    }
    QImage image(path);
    image = image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(1.0); // "@2x" in the name has set it
    if (image.width() == pixels || image.isNull())
        return image;
    return image.scaled(pixels, pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

class MaskEngine : public QIconEngine
{
public:
    enum class Use { Action, Row };

    /// own  valid: the colour whatever the theme's are
    MaskEngine(const QString &name, Use use, const QColor &own = {})
        : m_name(name), m_use(use), m_own(own)
    {
    }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override
    {
        const double ratio = painter->device()->devicePixelRatioF();
        const int size = std::min(rect.width(), rect.height());
        QRect place(0, 0, size, size);
        place.moveCenter(rect.center());
        painter->drawPixmap(place, tintedPixmap(m_name, size, colour(mode, state), ratio));
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        return tintedPixmap(m_name, std::min(size.width(), size.height()), colour(mode, state),
                            1.0);
    }

    QPixmap scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State state,
                         qreal scale) override
    {
        // `size` counts device pixels.
        const int side =
            static_cast<int>(std::lround(std::min(size.width(), size.height()) / scale));
        return tintedPixmap(m_name, side, colour(mode, state), scale);
    }

    QIconEngine *clone() const override { return new MaskEngine(m_name, m_use, m_own); }

private:
    QColor colour(QIcon::Mode mode, QIcon::State state) const
    {
        // An unfolded row has the state On too.
        QColor c = m_use == Use::Row    ? theme().muted
                   : state == QIcon::On ? theme().accent
                                        : theme().text;
        if (m_own.isValid())
            c = m_own;
        if (mode == QIcon::Selected)
            c = theme().onAccent;
        if (mode == QIcon::Disabled)
            c.setAlphaF(0.38f);
        return c;
    }

    QString m_name;
    Use m_use;
    QColor m_own;
};

} // namespace

QIcon themedIcon(const QString &name)
{
    return QIcon(new MaskEngine(name, MaskEngine::Use::Action));
}

QIcon rowIcon(const QString &name)
{
    return QIcon(new MaskEngine(name, MaskEngine::Use::Row));
}

QIcon colouredIcon(const QString &name, const QColor &colour)
{
    return QIcon(new MaskEngine(name, MaskEngine::Use::Row, colour));
}

QPixmap tintedPixmap(const QString &name, int size, const QColor &colour, double pixelRatio)
{
    const QString key = QStringLiteral("fff/%1/%2/%3/%4")
                            .arg(name)
                            .arg(size)
                            .arg(colour.rgba(), 8, 16)
                            .arg(pixelRatio);
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap))
        return pixmap;
    QImage image = mask(name, static_cast<int>(std::lround(size * pixelRatio)));
    if (image.isNull())
        return {};
    {
        QPainter painter(&image);
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        painter.fillRect(image.rect(), colour);
    }
    pixmap = QPixmap::fromImage(image);
    pixmap.setDevicePixelRatio(pixelRatio);
    QPixmapCache::insert(key, pixmap);
    return pixmap;
}

} // namespace fff::ui
