// The name of what Export writes, the folder that it goes to, and a link to change both. A name
// that is too long loses its middle; the whole path is the tooltip.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

class QDir;
class QLabel;

namespace fff::ui {

class LinkRow;

class ExportPlaceRow : public QWidget
{
    Q_OBJECT
public:
    explicit ExportPlaceRow(QWidget *parent = nullptr);

    /// "shelf.svg in Documents"
    static QString placeText(const QString &name, const QDir &folder);

    /// isFirst: of several files, which follow it by number.
    void setPath(const QString &path, bool isFirst);

Q_SIGNALS:
    void changeWanted();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    static QString textOf(const QString &name, const QString &folder, bool isFirst);
    void refresh();

    QString m_name, m_folder;
    bool m_isFirst = false;
    QLabel *m_words = nullptr;
    LinkRow *m_change = nullptr;
};

} // namespace fff::ui
