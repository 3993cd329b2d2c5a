#include "ui/dialogs/file_question.h"

#include "ui/properties/choice_box.h"

#include <QCheckBox>

#include <algorithm>

namespace fff::ui {

namespace {

const QString kPerSheet = QStringLiteral("/sheets"); // what such a key ends in

QString useText(io::FileUse use)
{
    switch (use) {
    case io::FileUse::Cutting:
        return FileQuestion::tr("Cutting file");
    case io::FileUse::Paper:
        return FileQuestion::tr("Paper or picture");
    case io::FileUse::Solids:
        return FileQuestion::tr("Solids to print or render");
    case io::FileUse::Parts:
        return FileQuestion::tr("List of parts");
    case io::FileUse::Workshop:
        return FileQuestion::tr("Everything for a workshop");
    }
    return {}; // not reached: every use is above
}

std::optional<std::size_t> fileNamed(const std::vector<ExportFile> &files, const QString &key)
{
    const auto found = std::find_if(files.begin(), files.end(),
                                    [&key](const ExportFile &one) { return one.key == key; });
    if (found == files.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - files.begin());
}

} // namespace

FileQuestion::FileQuestion(std::vector<ExportFile> files, const QStringList &chosen,
                           QWidget *parent)
    : QuestionRow(tr("Which file?"), parent), m_files(std::move(files))
{
    const auto box = [this](const char *objectName, const QString &name) {
        auto *one = new ChoiceBox(this);
        one->setObjectName(QLatin1String(objectName));
        one->setAccessibleName(name);
        one->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        one->setMinimumContentsLength(20);
        add(one);
        return one;
    };
    m_useBox = box("exportUse", tr("What is it for?"));
    m_wayBox = box("exportFile", tr("Which file?"));
    m_perSheet = new QCheckBox(tr("A file for each sheet"), this);
    m_perSheet->setObjectName(QStringLiteral("exportFilePerSheet"));
    add(m_perSheet);
    for (const QString &key : chosen)
        if (fileNamed(m_files, key))
            m_chosen += key;
    if (!m_chosen.isEmpty())
        m_file = *fileNamed(m_files, m_chosen.front());
    connect(m_useBox, &QComboBox::activated, this, &FileQuestion::chooseUse);
    connect(m_wayBox, &QComboBox::activated, this, [this](int choice) {
        const std::size_t whole = ways()[static_cast<std::size_t>(choice)];
        choose(file().isFilePerSheet ? otherOf(whole) : whole);
    });
    connect(m_perSheet, &QCheckBox::clicked, this, [this] { choose(otherOf(m_file)); });
    refresh();
}

QStringList FileQuestion::chosen() const
{
    QStringList keys{file().key};
    for (const QString &key : m_chosen)
        if (m_files[*fileNamed(m_files, key)].use != file().use)
            keys += key;
    return keys;
}

std::vector<io::FileUse> FileQuestion::uses() const
{
    std::vector<io::FileUse> all;
    for (const ExportFile &one : m_files)
        if (std::find(all.begin(), all.end(), one.use) == all.end())
            all.push_back(one.use);
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<std::size_t> FileQuestion::ways() const
{
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < m_files.size(); ++i)
        if (m_files[i].use == file().use && !m_files[i].isFilePerSheet)
            all.push_back(i);
    return all;
}

std::size_t FileQuestion::otherOf(std::size_t one) const
{
    const QString &key = m_files[one].key;
    return fileNamed(m_files,
                     m_files[one].isFilePerSheet ? key.chopped(kPerSheet.size()) : key + kPerSheet)
        .value_or(one);
}

void FileQuestion::choose(std::size_t one)
{
    m_chosen = chosen(); // so that another use finds what was chosen of this one
    m_file = one;
    refresh();
    Q_EMIT fileChanged();
}

/// What was chosen of it the last time, else the first.
void FileQuestion::chooseUse(int choice)
{
    const io::FileUse use = uses()[static_cast<std::size_t>(choice)];
    if (use == file().use)
        return;
    for (const QString &key : m_chosen)
        if (const std::size_t one = *fileNamed(m_files, key); m_files[one].use == use)
            return choose(one);
    const auto first = std::find_if(m_files.begin(), m_files.end(),
                                    [use](const ExportFile &one) { return one.use == use; });
    choose(static_cast<std::size_t>(first - m_files.begin()));
}

void FileQuestion::refresh()
{
    Choices useChoices, wayChoices;
    for (const io::FileUse use : uses()) {
        if (use == file().use)
            useChoices.current = static_cast<int>(useChoices.all.size());
        useChoices.all.push_back({useText(use), {}});
    }
    const std::size_t whole = file().isFilePerSheet ? otherOf(m_file) : m_file;
    for (const std::size_t way : ways()) {
        if (way == whole)
            wayChoices.current = static_cast<int>(wayChoices.all.size());
        wayChoices.all.push_back({m_files[way].text, {}});
    }
    m_useBox->setChoices(useChoices);
    m_wayBox->setChoices(wayChoices);
    m_wayBox->setVisible(wayChoices.all.size() > 1);
    m_perSheet->setVisible(otherOf(m_file) != m_file);
    m_perSheet->setChecked(file().isFilePerSheet);
}

} // namespace fff::ui
