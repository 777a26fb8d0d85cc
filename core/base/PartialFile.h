#pragma once
/// Files that are being written. They stand in the folder of their place under a name of their own, and are locked while they are: what a
/// killed program has left can be told from what another one writes.

#include <string>

namespace lubberline {

/// A new file, open and locked, that is gone with this object unless it was renamed.
class PartialFile {
public:
    /// Removes what was left in that folder, too. isOpen() is false where no file can be made; errno says why.
    explicit PartialFile(const std::string& folder);
    ~PartialFile();
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    [[nodiscard]] bool isOpen() const { return m_handle >= 0; }
    [[nodiscard]] int handle() const { return m_handle; }
    [[nodiscard]] const std::string& name() const { return m_name; }
    /// On the drive, whoever wrote into it. Some drives tell only then that they are full.
    bool finish();
    /// After finish(). The lock goes with it.
    bool renameTo(const std::string& target);

private:
    std::string m_name;
    int m_handle = -1;
    bool m_left = false;
};

/// Removes what programs that were killed have left in a folder. What another program writes at this moment stays, and so does what
/// is another user's.
void removeLeftovers(const std::string& folder);

} // namespace lubberline
