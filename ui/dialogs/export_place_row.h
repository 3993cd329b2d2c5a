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

    /// Says so where there is such a file.
    /// isFirst  of several files, which follow it by number
    void setPath(const QString &path, bool isFirst);

Q_SIGNALS:
    void changeWanted();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    enum class Kind {
        New,
        Replaced, // by what is written
        First,    // of several, which follow it by number
    };
    static QString textOf(const QString &name, const QString &folder, Kind kind);
    void refresh();

    QString m_name, m_folder;
    Kind m_kind = Kind::New;
    QLabel *m_words = nullptr;
    LinkRow *m_change = nullptr;
};

} // namespace fff::ui
