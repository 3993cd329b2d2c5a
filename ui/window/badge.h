// One verdict as a pill: outlined with a green check when it is good, filled red with an octagon
// when it is not.
#pragma once

#include <QAbstractButton> // first: moc stumbles over some standard headers
#include <QVariantAnimation>

#include "core/analysis/finding.h"

namespace fff::ui {

class Badge : public QAbstractButton
{
    Q_OBJECT
public:
    struct Content
    {
        Severity severity = Severity::Good;
        QString title, sentence;
        bool isOlder = false;       // than the drawing: not said as if it were known
        bool isProvisional = false; // what would be if a stroke ended now: dashed
        bool operator==(const Content &) const = default;
    };

    explicit Badge(QWidget *parent = nullptr);

    /// One that turns bad fills from the left, once.
    void setContent(const Content &content);
    Severity severity() const { return m_content.severity; }
    /// Its glyph alone.
    void setFolded(bool isFolded);
    /// px
    int widthWhen(bool isFolded) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QFont words() const;

    Content m_content;
    bool m_isFolded = false;
    QVariantAnimation m_fill;
};

} // namespace fff::ui
