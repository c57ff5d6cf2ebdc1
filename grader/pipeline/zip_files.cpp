#include "grader/pipeline/zip_files.h"

#include <archive.h>
#include <archive_entry.h>

#include <memory>

#include "course/runner/descriptors.h"
#include "course/runner/exercises.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

class ZipWriter {
public:
    ZipWriter() {
        const auto no_close = [](archive*, void*) { return ARCHIVE_OK; };
        check(archive_write_set_format_zip(to_.get()));
        archive_write_set_bytes_in_last_block(to_.get(), 1);
        check(
            archive_write_open(to_.get(), &bytes_, nullptr, append, no_close));
    }

    void add(const std::string& name, const std::string& bytes, bool may_run) {
        const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(
            archive_entry_new(), archive_entry_free);
        archive_entry_set_pathname(entry.get(), name.c_str());
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), may_run ? 0755 : 0644);
        archive_entry_set_size(entry.get(),
                               static_cast<la_int64_t>(bytes.size()));
        check(archive_write_header(to_.get(), entry.get()));
        if (archive_write_data(to_.get(), bytes.data(), bytes.size()) < 0)
            throw course::SystemError(archive_error_string(to_.get()));
    }

    std::string finish() {
        check(archive_write_close(to_.get()));
        return std::move(bytes_);
    }

private:
    struct Free {
        void operator()(archive* a) const { archive_write_free(a); }
    };

    static la_ssize_t append(archive*, void* to, const void* data,
                             std::size_t size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                              size);
        return static_cast<la_ssize_t>(size);
    }

    void check(int result) const {
        if (result != ARCHIVE_OK)
            throw course::SystemError(archive_error_string(to_.get()));
    }

    std::string bytes_;
    std::unique_ptr<archive, Free> to_{archive_write_new()};
};

bool may_be_run(const fs::path& file) {
    return (fs::status(file).permissions() & fs::perms::owner_exec) !=
           fs::perms::none;
}

}  // namespace

std::string zip_of_files(const std::map<std::string, fs::path>& files) {
    ZipWriter writer;
    for (const auto& [name, file] : files)
        writer.add(name, course::read_file(file), may_be_run(file));
    return writer.finish();
}

std::map<std::string, fs::path> files_to_pack(const fs::path& folder,
                                              const std::string& name) {
    std::map<std::string, fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files[name + "/" +
                  entry.path().lexically_relative(folder).string()] =
                entry.path();
    return files;
}

}  // namespace grader
