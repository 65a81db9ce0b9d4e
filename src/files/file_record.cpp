// SPDX-License-Identifier: MIT
#include "files/file_record.hpp"

#include <array>

#include "files/content_hash.hpp"
#include "files/file_error.hpp"

namespace nicol {
namespace {

constexpr int kReadAttempts = 3;

/// Returns a text that changes when the file changes; empty if there is no such file.
std::string identity_of(const FileSource& files, const std::filesystem::path& file) {
    const auto found = files.find(file);
    return found ? found->identity : std::string();
}

}  // namespace

FileRecord record_of(const std::filesystem::path& file, const LoadBudget& budget) {
    const auto in = budget.files().open(file);
    if (!in) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read");
    FileRecord record;
    record.path = file;
    ContentHash hash;
    std::array<char, 1 << 16> buffer;
    while (in->read(buffer.data(), buffer.size()), in->gcount() > 0) {
        const auto count = static_cast<std::size_t>(in->gcount());
        hash.add({reinterpret_cast<const unsigned char*>(buffer.data()), count});
        record.bytes += count;
        budget.step(count);
    }
    record.digest = hash.text();
    return record;
}

FileRecord record_of(const std::filesystem::path& file, const std::string& bytes) {
    return {.path = file, .bytes = bytes.size(), .digest = ContentHash().add(bytes).text()};
}

FileRecorder::State FileRecorder::state_of(std::span<const std::filesystem::path> files) const {
    State state;
    for (const std::filesystem::path& file : files) {
        Seen& seen = state.emplace_back();
        seen.identity = identity_of(budget_.files(), file);
        if (!seen.identity.empty()) seen.record = record_of(file, budget_);
    }
    return state;
}

bool FileRecorder::keep(std::span<const std::filesystem::path> files, const State& before, int attempt) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (identity_of(budget_.files(), files[i]) == before[i].identity) continue;
        if (attempt == kReadAttempts) invalid_file(files[i], "changes while it is read");
        return false;
    }
    for (const auto& [identity, record] : before)
        if (!record.path.empty() && recorded_.insert(record.path).second) records_.push_back(record);
    return true;
}

}  // namespace nicol
