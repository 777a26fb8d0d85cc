#include "db/chain/ChainCheck.h"

#include <map>

#include "db/engine/Statement.h"

namespace lubberline::db {

namespace {

struct LinkedEntry {
    ChainEntry entry;
    std::string link, fileLink;
};

const QString kLinked = "SELECT id, time_utc, what, record, detail, link, file_link FROM audit_entry ";

LinkedEntry linkedFrom(const Statement& row)
{
    return {{row.integer(0), row.text(1), row.text(2), row.text(3), row.longText(4)}, row.text(5), row.text(6)};
}

Message named(const ChainEntry& entry)
{
    return {MARKED("db", "entry %1 (%2, %3, record %4)"), entry.id, entry.timeUtc, entry.what, entry.record};
}

class Walk {
public:
    explicit Walk(ChainHead head) : m_head(std::move(head)), m_before(m_head.file) {}

    void step(const LinkedEntry& one)
    {
        const ChainEntry& entry = one.entry;
        std::string& record = m_records[entry.record];
        const bool follows = fileLink(m_before, one.link) == one.fileLink;
        const bool same = recordLink(record, entry) == one.link;
        if (one.link.empty())
            find({MARKED("db", "%1 was put in behind the program's back"), named(entry)});
        else if (!follows && entry.id > m_last + 1)
            missing(m_last + 1, entry.id - 1);
        else if (!follows)
            find({MARKED("db", "%1 does not follow the one before it: an entry was taken out, put in, changed or moved"), named(entry)});
        if (!one.link.empty() && !same && follows)
            find(m_displaced ? Message(MARKED("db", "%1 does not follow the entry before it of its record"), named(entry))
                             : Message(MARKED("db", "%1 is not what was written: it was changed"), named(entry)));
        else if (!one.link.empty() && !same && m_report.findings.empty())
            find({MARKED("db", "%1 is not what was written: it was changed"), named(entry)});
        m_displaced = m_displaced || !follows;
        if (entry.timeUtc < m_time)
            m_report.notes.push_back(
                {MARKED("db", "%1 stands before the entry before it (%2): the clock had been set back"), named(entry), m_time});
        m_time = entry.timeUtc;
        m_last = entry.id;
        m_before = one.fileLink;
        record = one.link;
    }

    ChainReport end()
    {
        if (m_last < m_head.entries)
            missing(m_last + 1, m_head.entries);
        else if (m_last > m_head.entries || m_before != m_head.head)
            find({MARKED("db", "the head of the audit trail is not that of its last entry, %1"), m_last});
        if (m_head.before > m_head.entries)
            find({MARKED(
                      "db", "the head of the audit trail says that %1 entries were there when it was begun; expected no more than its %2"),
                m_head.before, m_head.entries});
        else if (m_head.before > 0)
            m_report.notes.push_back(
                {MARKED("db", "the audit trail is chained from %1 on: the %2 entries before are as they were found then"), m_head.sinceUtc,
                    m_head.before});
        return std::move(m_report);
    }

private:
    void find(Message message) { m_report.findings.push_back(std::move(message)); }
    void missing(std::int64_t from, std::int64_t to)
    {
        find(from == to ? Message(MARKED("db", "entry %1 is missing"), from)
                        : Message(MARKED("db", "entries %1 to %2 are missing"), from, to));
    }

    ChainHead m_head;
    std::string m_before; ///< the file's link so far
    std::map<std::string, std::string> m_records;
    std::int64_t m_last = 0;
    std::string m_time;
    bool m_displaced = false; ///< an entry is not where it was: what follows on its record may be whole
    ChainReport m_report;
};

} // namespace

Result<ChainReport> checkChain(const Database& database, const std::vector<NotedHead>& noted)
{
    auto head = chainHead(database);
    if (!head)
        return head.error();
    std::vector<bool> found;
    for (const auto& one : noted)
        found.push_back(head->file.starts_with(one.head));
    std::multimap<std::string, std::size_t> wanted; // by their first digits, so that each entry is looked up once
    constexpr std::size_t kFirst = 12;
    for (std::size_t i = 0; i < noted.size(); ++i)
        wanted.emplace(noted[i].head.substr(0, kFirst), i);
    Walk walk(std::move(head.value()));
    Statement statement(database, kLinked + "ORDER BY id");
    if (const auto done = statement.run(); !done)
        return done.error();
    while (statement.next()) {
        const LinkedEntry one = linkedFrom(statement);
        walk.step(one);
        for (auto [at, last] = wanted.equal_range(one.fileLink.substr(0, kFirst)); at != last; ++at)
            if (one.fileLink.starts_with(noted[at->second].head))
                found[at->second] = true;
    }
    if (const auto read = statement.finished(); !read)
        return read.error();
    ChainReport report = walk.end();
    for (std::size_t i = 0; i < noted.size(); ++i)
        if (!found[i])
            report.findings.push_back({MARKED("db", "the audit trail does not hold the head %1… of %2: it was cut off, or is another's"),
                noted[i].head.substr(0, kFirst), noted[i].where});
    return report;
}

Result<std::vector<Message>> checkRecordChain(const Database& database, const std::string& record)
{
    Statement statement(database, kLinked + "WHERE record = ? ORDER BY id");
    statement << record;
    const auto entries = rowsOf<LinkedEntry>(statement, [](Statement& row) { return linkedFrom(row); });
    if (!entries)
        return entries.error();
    std::vector<Message> findings;
    std::string before;
    for (const auto& one : *entries) {
        if (one.link.empty())
            findings.push_back({MARKED("db", "%1 was put in behind the program's back"), named(one.entry)});
        else if (recordLink(before, one.entry) != one.link)
            findings.push_back({MARKED("db", "%1 was changed, or the entry before it was taken out"), named(one.entry)});
        before = one.link;
    }
    return findings;
}

} // namespace lubberline::db
