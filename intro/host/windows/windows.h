// The functions of Windows that we use, by library, declared in our calling convention. Each is a stub in
// calls.cpp that converts the call to Windows's convention.
//
// Their types are spelled out here, because a compiler for Linux cannot read Windows's own header. A function
// whose name ends with W takes texts in UTF-16. A function that returns an int returns 0 if it fails, unless
// stated otherwise.
#pragma once

#include <stdint.h>

namespace odraz::windows {

typedef void *Handle;
typedef uint16_t Wide; // a unit of UTF-16

// Loads the functions of kernel32.dll. It must be called before any other function of Windows.
void begin();

// The last error, GetLastError
enum Error : uint32_t {
    kFileNotFound = 2,
    kPathNotFound = 3,
    kAccessDenied = 5,
    kInvalidHandle = 6,
    kWriteProtect = 19,
    kSharing = 32,
    kHandleDiskFull = 39,
    kFileExists = 80,
    kBrokenPipe = 109,
    kDiskFull = 112,
    kAlreadyExists = 183,
    kNameTooLong = 206,
    kNoData = 232,
    kNotConnected = 233,
    kNoDirectory = 267,
};

constexpr uint32_t kUtf8 = 65001;
inline const Handle kInvalid = (Handle)-1; // also the pseudo handle of this process

// Returns the handle of a standard descriptor, 0 to 2; an invalid handle if it is closed.
Handle standard(int descriptor);

// clang-format off
#define ODRAZ_KERNEL32(F) \
    F(AttachConsole) F(CloseHandle) F(CreateDirectoryW) F(CreateFileW) F(CreateSemaphoreA) F(CreateThread) \
    F(DeleteFileW) F(ExitThread) F(GetCommandLineW) F(GetConsoleMode) F(GetCurrentProcessId) F(GetFileAttributesExW) \
    F(GetFileType) F(GetLastError) F(GetModuleFileNameW) F(GetProcessAffinityMask) F(GetProcessTimes) \
    F(GetStdHandle) F(MoveFileExW) F(MultiByteToWideChar) F(QueryPerformanceCounter) \
    F(QueryPerformanceFrequency) F(ReleaseSemaphore) F(SetStdHandle) F(SetThreadExecutionState) F(Sleep) F(TerminateProcess) \
    F(VirtualAlloc) F(VirtualFree) F(WaitForSingleObject) F(WideCharToMultiByte) F(WriteConsoleW) F(WriteFile)
#define ODRAZ_USER32(F) \
    F(AdjustWindowRect) F(CreateWindowExA) F(DefWindowProcA) F(DispatchMessageA) F(GetDC) F(GetKeyState) \
    F(GetMessageA) F(GetSystemMetrics) F(MessageBoxW) F(RegisterClassA) F(SetCursor) F(SetForegroundWindow) \
    F(SetProcessDPIAware) F(SetWindowLongA) F(SetWindowPos)
#define ODRAZ_GDI32(F) F(ChoosePixelFormat) F(SetPixelFormat) F(SwapBuffers)
#define ODRAZ_OPENGL32(F) F(wglCreateContext) F(wglGetProcAddress) F(wglMakeCurrent)
#define ODRAZ_WINMM(F) \
    F(timeBeginPeriod) F(waveOutClose) F(waveOutGetPosition) F(waveOutOpen) F(waveOutPause) F(waveOutPrepareHeader) \
    F(waveOutReset) F(waveOutRestart) F(waveOutUnprepareHeader) F(waveOutWrite)
// clang-format on

struct PixelFormat {
    uint16_t size, version;
    uint32_t flags;
    uint8_t type, colourBits, rest[30];
};
static_assert(sizeof(PixelFormat) == 40);

struct WindowClass {
    uint32_t style;
    void *receive; // an ms_abi function: gets a window, a message and its two values, and returns the result
    int more[2];
    Handle module, icon, cursor, background;
    const char *menu, *name;
};

struct WaveFormat {
    uint16_t kind, channels;
    uint32_t rate, bytesPerSecond;
    uint16_t bytesPerFrame, bits, more;
};

struct WaveHeader {
    void *data;
    uint32_t size, recorded;
    void *context;
    uint32_t flags, loops;
    void *next, *reserved;
};
static_assert(sizeof(WaveHeader) == 48);

struct WaveTime {
    uint32_t kind, samples, more;
};

struct FileAttributes {
    uint32_t attributes, times[6], sizeHigh, sizeLow;
};

} // namespace odraz::windows

// Types and functions, under the names that Windows gives them
extern "C" {
typedef odraz::windows::Handle HANDLE;
typedef odraz::windows::Wide WCHAR;

// The program's only two imports, in Windows's own convention
__attribute__((noplt, ms_abi)) void *LoadLibraryA(const char *name);
__attribute__((noplt, ms_abi)) void *GetProcAddress(void *library, const char *name);

// kernel32
int AttachConsole(uint32_t process);
int CloseHandle(HANDLE);
int CreateDirectoryW(const WCHAR *path, void *security);
HANDLE CreateFileW(const WCHAR *path, uint32_t access, uint32_t share, void *security, uint32_t how,
                   uint32_t attributes, HANDLE like);
HANDLE CreateSemaphoreA(void *security, int first, int most, const char *name);
HANDLE CreateThread(void *security, uint64_t stack, void *body, void *context, uint32_t flags, uint32_t *id);
int DeleteFileW(const WCHAR *path);
void ExitThread(uint32_t status);
const WCHAR *GetCommandLineW();
int GetConsoleMode(HANDLE, uint32_t *mode);
uint32_t GetCurrentProcessId();
int GetFileAttributesExW(const WCHAR *path, int level, odraz::windows::FileAttributes *);
uint32_t GetFileType(HANDLE);
uint32_t GetLastError();
uint32_t GetModuleFileNameW(HANDLE, WCHAR *name, uint32_t room);
int GetProcessAffinityMask(HANDLE, uint64_t *process, uint64_t *system);
int GetProcessTimes(HANDLE, uint64_t *begun, uint64_t *ended, uint64_t *kernel, uint64_t *user);
HANDLE GetStdHandle(uint32_t which);
int MoveFileExW(const WCHAR *from, const WCHAR *to, uint32_t flags);
int MultiByteToWideChar(uint32_t page, uint32_t flags, const char *, int bytes, WCHAR *to, int room);
int QueryPerformanceCounter(int64_t *);
int QueryPerformanceFrequency(int64_t *);
int ReleaseSemaphore(HANDLE, int count, int *before);
int SetStdHandle(uint32_t which, HANDLE);
uint32_t SetThreadExecutionState(uint32_t state);
void Sleep(uint32_t milliseconds);
int TerminateProcess(HANDLE, uint32_t status);
void *VirtualAlloc(void *at, uint64_t bytes, uint32_t how, uint32_t protection);
int VirtualFree(void *at, uint64_t bytes, uint32_t how);
uint32_t WaitForSingleObject(HANDLE, uint32_t milliseconds);
int WideCharToMultiByte(uint32_t page, uint32_t flags, const WCHAR *, int units, char *to, int room,
                        const char *otherwise, int *used);
int WriteConsoleW(HANDLE, const WCHAR *text, uint32_t units, uint32_t *written, void *reserved);
int WriteFile(HANDLE, const void *data, uint32_t size, uint32_t *written, void *overlapped);

int AdjustWindowRect(int area[4], uint32_t style, int menu);
HANDLE CreateWindowExA(uint32_t more, const char *kind, const char *title, uint32_t style, int x, int y,
                       int width, int height, HANDLE parent, HANDLE menu, HANDLE module, void *context);
int64_t DefWindowProcA(HANDLE window, uint32_t message, uint64_t a, uint64_t b);
int64_t DispatchMessageA(const void *message);
HANDLE GetDC(HANDLE window);
int16_t GetKeyState(int key); // < 0 while it is down
int GetMessageA(void *message /* 48 bytes */, HANDLE window, uint32_t first,
                uint32_t last); // < 0 if it fails
int GetSystemMetrics(int which);
int MessageBoxW(HANDLE window, const WCHAR *text, const WCHAR *title, uint32_t flags);
uint16_t RegisterClassA(const odraz::windows::WindowClass *);
HANDLE SetCursor(HANDLE);
int SetForegroundWindow(HANDLE window);
int SetProcessDPIAware();
int SetWindowLongA(HANDLE window, int which, int value);
int SetWindowPos(HANDLE window, HANDLE after, int x, int y, int width, int height, uint32_t flags);

int ChoosePixelFormat(HANDLE dc, const odraz::windows::PixelFormat *);
int SetPixelFormat(HANDLE dc, int format, const odraz::windows::PixelFormat *);
int SwapBuffers(HANDLE dc);

HANDLE wglCreateContext(HANDLE dc);
void *wglGetProcAddress(const char *name);
int wglMakeCurrent(HANDLE dc, HANDLE context);

// These return 0, or an error
uint32_t timeBeginPeriod(uint32_t milliseconds);
uint32_t waveOutClose(HANDLE);
uint32_t waveOutGetPosition(HANDLE, odraz::windows::WaveTime *, uint32_t size);
uint32_t waveOutOpen(HANDLE *, uint32_t device, const odraz::windows::WaveFormat *, void *callback,
                     void *context, uint32_t flags);
uint32_t waveOutPause(HANDLE);
uint32_t waveOutPrepareHeader(HANDLE, odraz::windows::WaveHeader *, uint32_t size);
uint32_t waveOutReset(HANDLE);
uint32_t waveOutRestart(HANDLE);
uint32_t waveOutUnprepareHeader(HANDLE, odraz::windows::WaveHeader *, uint32_t size);
uint32_t waveOutWrite(HANDLE, odraz::windows::WaveHeader *, uint32_t size);
}
