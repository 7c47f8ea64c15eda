// Files are whole or absent, whatever goes wrong. ../probe.sh checks which files remain in the folder.
#include "probe.h"

#include "base/text.h"
#include "host/files.h"

using namespace odraz;

namespace probe {

namespace {

typedef PROBE_WINDOWS void *CreateFileFunction(const WCHAR *, uint32_t, uint32_t, void *, uint32_t, uint32_t,
                                               void *);
typedef PROBE_WINDOWS int CreateDirectoryFunction(const WCHAR *, void *);
typedef PROBE_WINDOWS int CloseHandleFunction(void *);
void *theUsual;

void setError(uint32_t error) {
    ((PROBE_WINDOWS void (*)(uint32_t))function("kernel32.dll", "SetLastError"))(error);
}

// Real Windows, unlike Wine, limits names without a manifest to 259 units, and folders to 247
int length(const WCHAR *path) {
    int n = 0;
    while (path[n]) ++n;
    return n;
}
PROBE_WINDOWS void *createFile(const WCHAR *path, uint32_t access, uint32_t share, void *security,
                               uint32_t how, uint32_t attributes, void *like) {
    if (length(path) < 260)
        return ((CreateFileFunction *)theUsual)(path, access, share, security, how, attributes, like);
    setError(windows::kPathNotFound);
    return windows::kInvalid;
}
PROBE_WINDOWS int createDirectory(const WCHAR *path, void *security) {
    if (length(path) < 248) return ((CreateDirectoryFunction *)theUsual)(path, security);
    setError(windows::kPathNotFound);
    return 0;
}
PROBE_WINDOWS int fullDisk(void *, const void *, uint32_t, uint32_t *, void *) {
    setError(windows::kDiskFull);
    return 0;
}
PROBE_WINDOWS int fullAtLast(void *handle) {
    ((CloseHandleFunction *)theUsual)(handle);
    setError(windows::kDiskFull);
    return 0;
}

const char *const kFull = "no space left on the device", *const kLong = "the name is too long";

} // namespace

void names(const char *folder) {
    auto below = [&](AnyText &path, const char *name) -> const char * {
        path << folder << '/' << name;
        return path.data;
    };
    Text<6000> a, b, c, d, e, f, g, h, part;
    check("a file is written", !writeFile(below(a, "a"), "one", 3));
    check("... over what is there", !writeFile(a.data, "three", 5));
    below(part, "b.");
    part << (int64_t)GetCurrentProcessId() << ".part";
    check("the name beside it is taken", !writeFile(part.data, "somebody's", 10));
    check("... and stays as it is", !writeFile(below(b, "b"), "ours", 4));
    check("nothing is written to NUL", !writeFile("NUL", "x", 1));

    check("a folder keeps its place", is(writeFile(folder, "x", 1), "it is a directory"));
    check("a folder that is missing is reported",
          is(writeFile(below(c, "no/where"), "x", 1), "no such directory"));
    WCHAR wide[600];
    MultiByteToWideChar(windows::kUtf8, 0, below(d, "held"), -1, wide, 600);
    HANDLE held = CreateFileW(wide, 0x40000000, 0, nullptr, 1, 0, nullptr);
    check("what another has open is left to it", is(writeFile(d.data, "x", 1), "permission denied"));
    CloseHandle(held);

    const char *wrong, *over;
    {
        Instead write(kernelSlot("WriteFile"), (void *)fullDisk);
        wrong = writeFile(below(e, "full"), "x", 1);
        over = writeFile(a.data, "x", 1);
    }
    check("a full disk is reported", is(wrong, kFull));
    check("... where something is there, too", is(over, kFull));
    {
        Instead close(kernelSlot("CloseHandle"), (void *)fullAtLast);
        theUsual = close.usual;
        wrong = writeFile(below(f, "late"), "x", 1);
    }
    check("one that is full only when it is closed, too", is(wrong, kFull));

    // Long names
    below(g, "");
    while (g.size < 300) g << "long/";
    below(h, "");
    while (h.size < 5000) h << "longer/";
    {
        Instead create(kernelSlot("CreateFileW"), (void *)createFile);
        theUsual = create.usual;
        wrong = writeFile(g.data, "x", 1);
    }
    check("a name that is too long for Windows is reported", is(wrong, kLong));
    {
        Instead create(kernelSlot("CreateDirectoryW"), (void *)createDirectory);
        theUsual = create.usual;
        wrong = makeDirectory(g.data);
    }
    check("... a folder's, too", is(wrong, kLong));
    check("one that is too long for the film is reported", is(writeFile(h.data, "x", 1), kLong));
    check("... a folder's, too", is(makeDirectory(h.data), kLong));
    check("a folder that is there is fine", !makeDirectory(folder));
    check("one in a file's place is not", is(makeDirectory(a.data), "not a directory"));
}

} // namespace probe
