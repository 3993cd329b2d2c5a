#include "app/cli/table.h"

#include <algorithm>

namespace fff::cli {

namespace {

QChar separatorOf(const QString &text)
{
    constexpr char16_t kSeparators[] = {u';', u'\t', u','};
    bool isQuoted = false;
    bool isThere[3] = {false, false, false};
    for (const QChar c : text) {
        if (c == u'"')
            isQuoted = !isQuoted;
        else if (!isQuoted && (c == u'\n' || c == u'\r'))
            break;
        for (int i = 0; i < 3; ++i)
            isThere[i] = isThere[i] || (!isQuoted && c == kSeparators[i]);
    }
    for (int i = 0; i < 3; ++i)
        if (isThere[i])
            return kSeparators[i];
    return u',';
}

class TableReader
{
public:
    explicit TableReader(const QString &text) : m_text(text), m_separator(separatorOf(text)) {}

    std::optional<std::vector<TableRow>> read()
    {
        for (m_at = m_text.startsWith(u'\ufeff') ? 1 : 0; m_at < m_text.size(); ++m_at)
            take(m_text[m_at]);
        if (m_isQuoted)
            return std::nullopt;
        endRow();
        return std::move(m_rows);
    }

private:
    void take(QChar c)
    {
        if (c == u'\n')
            ++m_line;
        if (m_isQuoted && c == u'"' && m_at + 1 < m_text.size() && m_text[m_at + 1] == u'"') {
            m_cell += c;
            ++m_at;
        } else if (m_isQuoted && c != u'"') {
            m_cell += c;
        } else if (c == u'"' && (m_isQuoted || m_cell.trimmed().isEmpty())) {
            if (!m_wasQuoted)
                m_cell.clear(); // blanks before it
            m_isQuoted = !m_isQuoted;
            m_wasQuoted = true;
        } else if (c == m_separator) {
            endCell();
        } else if (c == u'\n') {
            endRow();
        } else if (c != u'\r') {
            m_cell += c;
        }
    }
    void endCell()
    {
        m_row.cells += m_wasQuoted ? m_cell : m_cell.trimmed();
        m_cell.clear();
        m_wasQuoted = false;
    }
    void endRow()
    {
        endCell();
        const bool isEmpty = std::all_of(m_row.cells.begin(), m_row.cells.end(),
                                         [](const QString &cell) { return cell.isEmpty(); });
        if (!isEmpty)
            m_rows.push_back(std::move(m_row));
        m_row = {m_line, {}};
    }

    const QString &m_text;
    const QChar m_separator;
    qsizetype m_at = 0;
    int m_line = 1;
    bool m_isQuoted = false, m_wasQuoted = false;
    QString m_cell;
    TableRow m_row{1, {}};
    std::vector<TableRow> m_rows;
};

} // namespace

std::optional<std::vector<TableRow>> readTable(const QString &text)
{
    return TableReader(text).read();
}

} // namespace fff::cli
