// Where what a template shows comes from: kept in the model, or read from its file; and a way back
// to a file that is not found.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include <functional>

class QPushButton;

namespace fff {
struct Template;
}

namespace fff::ui {

class TextRow;

class TemplateSource : public QWidget
{
    Q_OBJECT
public:
    /// chosen  the one that is shown; null: none
    explicit TemplateSource(std::function<const Template *()> chosen, QWidget *parent = nullptr);
    void refresh();

Q_SIGNALS:
    /// Its file is to be found, and read from there from now on where isByReference.
    void fileWanted(bool isByReference);
    /// What was read from its file is to be kept in the model.
    void keepWanted();

private:
    const std::function<const Template *()> m_chosen;
    TextRow *m_file = nullptr;
    QPushButton *m_find = nullptr, *m_link = nullptr, *m_keep = nullptr;
};

} // namespace fff::ui
