// A card of the start page: a model's picture, its name, and a line about it.
#pragma once

#include <QAbstractButton>
#include <QImage>

namespace fff::ui {

class ModelCard : public QAbstractButton
{
    Q_OBJECT
public:
    static constexpr int kWidth = 176, kHeight = 132; // px
    static constexpr int kPictureHeight = 88;         // px; the width is that of the card

    explicit ModelCard(const QString &name, QWidget *parent = nullptr);

    void setPicture(const QImage &picture);
    void setNote(const QString &note);
    /// The file is gone: said instead of the picture.
    void setMissing();

    QSize sizeHint() const override { return {kWidth, kHeight}; }

Q_SIGNALS:
    /// Del was pressed on it.
    void removalWanted();

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void describe();
    void drawPicture(QPainter &painter, const QRect &room) const;

    QString m_note;
    QImage m_picture;
    bool m_isMissing = false;
};

} // namespace fff::ui
