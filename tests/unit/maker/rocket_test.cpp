#include "maker/rocket/client.h"

#include <arpa/inet.h>
#include <bit>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace odraz::maker::rocket;

static std::string number(uint32_t n) { return {(char)(n >> 24), (char)(n >> 16), (char)(n >> 8), (char)n}; }
static std::string setKey(uint32_t track, uint32_t row, float value, uint8_t interpolation) {
    return std::string(1, 0) + number(track) + number(row) + number(std::bit_cast<uint32_t>(value)) +
           (char)interpolation;
}
static std::string deleteKey(uint32_t track, uint32_t row) { return "\x01" + number(track) + number(row); }
static std::string setRow(uint32_t row) { return "\x03" + number(row); }

// An editor that sends what a test tells it to.
class Editor {
public:
    Editor() {
        listening = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(bind(listening, (sockaddr *)&address, size), 0);
        EXPECT_EQ(listen(listening, 4), 0);
        getsockname(listening, (sockaddr *)&address, &size);
    }
    ~Editor() {
        hangUp();
        close(listening);
    }
    int port() const { return ntohs(address.sin_port); }
    bool called() {
        pollfd p = {listening, POLLIN, 0};
        return poll(&p, 1, 0) > 0;
    }
    void answer() { talking = accept(listening, nullptr, nullptr); }
    void send(const std::string &bytes) {
        EXPECT_EQ(::send(talking, bytes.data(), bytes.size(), MSG_NOSIGNAL), (ssize_t)bytes.size());
    }
    // Waits for exactly `size` bytes.
    std::string receive(size_t size) {
        std::string all(size, 0);
        EXPECT_EQ(recv(talking, all.data(), size, MSG_WAITALL), (ssize_t)size);
        return all;
    }
    bool silent() {
        pollfd p = {talking, POLLIN, 0};
        return poll(&p, 1, 20) == 0;
    }
    void hangUp() {
        if (talking >= 0) close(talking);
        talking = -1;
    }

private:
    int listening, talking = -1;
    sockaddr_in address = {};
};

// Updates the client at the time `now` until `done`, at most for a quarter of an hour.
template <class Done> bool until(Client &client, double now, Done done) {
    for (int i = 0; i < 900000; ++i) {
        if (done()) return true;
        client.update(now);
        usleep(i < 100 ? 50 : 1000);
    }
    return false;
}

const std::vector<std::string> kNames = {"hall.camera:eye.x", "light"};

// Exchanges greetings and receives the requests for both tracks.
static void meet(Editor &editor, Client &client, double now = 0) {
    ASSERT_TRUE(until(client, now, [&] { return editor.called(); }));
    editor.answer();
    client.update(now);
    ASSERT_TRUE(until(client, now, [&] { return !editor.silent(); }));
    ASSERT_EQ(editor.receive(19), "hello, synctracker!");
    editor.send("hello, demo!");
    ASSERT_TRUE(until(client, now, [&] { return client.connected(); }));
    ASSERT_EQ(editor.receive(1 + 4 + 17 + 1 + 4 + 5),
              "\x02" + number(17) + "hall.camera:eye.x" + "\x02" + number(5) + "light");
}

TEST(RocketClient, ParsesEveryMessage) {
    Editor editor;
    Client client("127.0.0.1", editor.port(), kNames);
    meet(editor, client);
    EXPECT_EQ(client.problem(), "");
    EXPECT_FALSE(client.takeRow() || client.takePause() || client.takeSave());
    uint64_t before = client.version();
    std::string all = setKey(1, 8, 0.5f, 2) + setKey(0, 0, -1e9f, 0) + setKey(1, 16, 2, 3) +
                      setKey(1, 8, 0.75f, 1) + deleteKey(1, 16) + deleteKey(0, 77) + setRow(24) + "\x04\x01" +
                      "\x05";
    // Send it byte by byte
    for (char c : all) {
        editor.send(std::string(1, c));
        client.update(0);
    }
    ASSERT_TRUE(until(client, 0, [&] { return client.takeSave(); }));
    EXPECT_EQ(client.track(1), (Track{{8, {0.75f, Interpolation::Linear}}}));
    EXPECT_EQ(client.track(0), (Track{{0, {-1e9f, Interpolation::Step}}}));
    EXPECT_EQ(client.takeRow(), 24u);
    EXPECT_EQ(client.takePause(), true);
    EXPECT_FALSE(client.takeRow() || client.takePause() || client.takeSave());
    EXPECT_EQ(client.version(), before + 6);
    // Send it all at once: the last row counts
    editor.send(setRow(1) + std::string("\x04\0", 2) + setRow(2));
    ASSERT_TRUE(until(client, 0, [&, row = 0u]() mutable {
        if (auto sent = client.takeRow()) row = *sent;
        return row == 2;
    }));
    EXPECT_EQ(client.takePause(), false);
}

TEST(RocketClient, SendsItsRowOnce) {
    Editor editor;
    Client client("127.0.0.1", editor.port(), kNames);
    client.sendRow(5); // not connected yet
    meet(editor, client);
    client.sendRow(7);
    EXPECT_EQ(editor.receive(5), setRow(7));
    client.sendRow(7);
    EXPECT_TRUE(editor.silent());
    // A row from the editor is not sent back
    editor.send(setRow(9));
    ASSERT_TRUE(until(client, 0, [&] { return client.takeRow() == 9u; }));
    client.sendRow(9);
    EXPECT_TRUE(editor.silent());
    client.sendRow(10);
    EXPECT_EQ(editor.receive(5), setRow(10));
}

TEST(RocketClient, DisconnectsOnGarbage) {
    const std::string garbage[] = {
        "\x06",
        "\xff",
        "\x02" + number(1) + "a", // not a message for a client
        setKey(2, 0, 0, 0),       // there are two tracks
        setKey(0xffffffff, 0, 0, 0),
        setKey(0, 0, std::bit_cast<float>(0x7fc00000), 0),
        setKey(0, 0, std::bit_cast<float>(0xff800000), 0),
        setKey(0, 0, 0, 4),
        setKey(0, 0x80000000, 0, 0),
        deleteKey(5, 0),
        setRow(0xffffffff),
        "GET / HTTP/1.1\r\n\r\n",
    };
    for (const std::string &bytes : garbage) {
        Editor editor;
        Client client("127.0.0.1", editor.port(), kNames);
        meet(editor, client);
        editor.send(setKey(1, 4, 1, 1) + bytes);
        ASSERT_TRUE(until(client, 0, [&] { return !client.connected(); }));
        EXPECT_NE(client.problem().find("not in the protocol"), std::string::npos);
        EXPECT_EQ(client.track(1).size(), 1u); // keys sent before it are kept
    }
}

TEST(RocketClient, ComesBack) {
    Editor editor;
    Client client("127.0.0.1", editor.port(), kNames);
    meet(editor, client, 0);
    editor.send(setKey(1, 4, 1, 1));
    ASSERT_TRUE(until(client, 0, [&] { return !client.track(1).empty(); }));
    editor.hangUp();
    ASSERT_TRUE(until(client, 0.1, [&] { return !client.connected(); }));
    EXPECT_NE(client.problem().find("closed the connection"), std::string::npos);
    EXPECT_EQ(client.track(1).size(), 1u); // the film keeps the keys it has
    for (int i = 0; i < 100; ++i) client.update(0.9);
    EXPECT_FALSE(editor.called()); // not before a second has passed
    meet(editor, client, 1.1);
    EXPECT_TRUE(client.track(1).empty()); // the editor sends all keys again
    EXPECT_EQ(client.problem(), "");
}

TEST(RocketClient, ReportsAMissingEditor) {
    int port;
    {
        Editor nobody;
        port = nobody.port();
    }
    Client client("127.0.0.1", port, kNames);
    ASSERT_TRUE(until(client, 0, [&] { return !client.problem().empty(); }));
    EXPECT_NE(client.problem().find("127.0.0.1:" + std::to_string(port) + ": Connection refused"),
              std::string::npos)
        << client.problem();
    Client nowhere("no.such.host.invalid", 1, kNames);
    nowhere.update(0);
    EXPECT_NE(nowhere.problem().find("no.such.host.invalid:1: "), std::string::npos);
}

TEST(RocketClient, ReportsAServerThatIsNoEditor) {
    // A server with another greeting, in pieces; and a silent one
    for (bool silent : {false, true}) {
        Editor editor;
        Client client("127.0.0.1", editor.port(), kNames);
        ASSERT_TRUE(until(client, 0, [&] { return editor.called(); }));
        editor.answer();
        ASSERT_TRUE(until(client, 0, [&] { return !editor.silent(); }));
        if (!silent) editor.send("hello, d");
        for (int i = 0; i < 100; ++i) client.update(0);
        EXPECT_EQ(client.problem(), "");
        if (!silent) editor.send("ata");
        ASSERT_TRUE(until(client, silent ? 6 : 0, [&] { return !client.problem().empty(); }));
        EXPECT_NE(client.problem().find("no editor of GNU Rocket"), std::string::npos);
        EXPECT_FALSE(client.connected());
    }
}
