#pragma once
/// Key rings of gpg for tests: made anew, and gone with their agents. Without gpg the tests fail.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace lubberline::test {

class KeyRing {
public:
    KeyRing()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "lb-keys-XXXXXX").string(); // short: a socket stands in it
        m_folder = mkdtemp(pattern.data());
    }
    ~KeyRing()
    {
        run("gpgconf --kill all");
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    KeyRing(const KeyRing&) = delete;
    KeyRing& operator=(const KeyRing&) = delete;

    [[nodiscard]] std::string folder() const { return m_folder; }
    [[nodiscard]] std::string environment() const { return "GNUPGHOME=" + m_folder; }
    /// @return the exit status.
    int run(const std::string& command) const { return std::system((environment() + " " + command + " >/dev/null 2>&1").c_str()); }
    /// A signing key without a pass phrase. @param options "--faked-system-time 20200101T000000 …" @return its fingerprint; empty: there is no gpg.
    std::string make(const std::string& user, const std::string& options = {}, const std::string& expires = "never") const
    {
        run("gpg --batch " + options + " --passphrase '' --quick-gen-key '" + user + "' ed25519 sign " + expires);
        return output("gpg --batch --with-colons --list-secret-keys '" + user + "' | grep ^fpr | head -1 | cut -d: -f10");
    }
    /// Writes the public key to a file of the ring. @return its path.
    std::string publicKey(const std::string& fingerprint) const
    {
        const std::string path = m_folder + "/" + fingerprint.substr(0, 8) + ".asc";
        run("gpg --batch --yes --armor --output '" + path + "' --export " + fingerprint);
        return path;
    }
    void revoke(const std::string& fingerprint) const
    {
        const std::string made = m_folder + "/openpgp-revocs.d/" + fingerprint + ".rev";
        run("sh -c \"sed 's/^:---/---/' '" + made + "' | gpg --batch --import\""); // gpg writes it so that nobody imports it by chance
    }

private:
    [[nodiscard]] std::string output(const std::string& command) const
    {
        std::string text;
        if (FILE* pipe = ::popen((environment() + "; export GNUPGHOME; " + command + " 2>/dev/null").c_str(), "r")) {
            char part[256];
            while (std::fgets(part, sizeof part, pipe))
                text += part;
            ::pclose(pipe);
        }
        while (!text.empty() && text.back() == '\n')
            text.pop_back();
        return text;
    }
    std::string m_folder;
};

} // namespace lubberline::test
