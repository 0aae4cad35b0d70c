#include "viewer/plain_client.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <sstream>
#include <utility>

namespace latticeworld {
namespace {

constexpr int kPatience_s = 20;

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace

PlainClient::PlainClient(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  const timeval patience{kPatience_s, 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof(patience));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0) {
    ADD_FAILURE() << "cannot connect to port " << port;
  }
}

PlainClient::~PlainClient() {
  if (socket_ >= 0) ::close(socket_);
}

PlainClient::PlainClient(PlainClient&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), buffer_(std::move(other.buffer_)) {}

bool PlainClient::Send(const std::string& bytes) {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

bool PlainClient::Fill() {
  char bytes[65536];
  const ssize_t count = ::recv(socket_, bytes, sizeof(bytes), 0);
  if (count <= 0) return false;
  buffer_.append(bytes, static_cast<std::size_t>(count));
  return true;
}

bool PlainClient::Need(std::size_t bytes) {
  while (buffer_.size() < bytes) {
    if (!Fill()) return false;
  }
  return true;
}

bool PlainClient::WaitForEnd() {
  char bytes[65536];
  for (;;) {
    const ssize_t count = ::recv(socket_, bytes, sizeof(bytes), 0);
    if (count == 0) return true;
    if (count < 0) return errno == ECONNRESET || errno == EPIPE;
  }
}

PlainResponse PlainClient::ReadResponse(bool has_body) {
  PlainResponse response;
  std::size_t end;
  while ((end = buffer_.find("\r\n\r\n")) == std::string::npos) {
    if (!Fill()) return response;
  }
  std::istringstream head(buffer_.substr(0, end));
  buffer_.erase(0, end + 4);
  std::string version, line;
  head >> version >> response.status;
  std::getline(head, line);
  while (std::getline(head, line)) {
    const std::size_t colon = line.find(": ");
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (colon != std::string::npos) {
      response.headers[Lower(line.substr(0, colon))] = line.substr(colon + 2);
    }
  }
  const auto length = response.headers.find("content-length");
  if (!has_body || length == response.headers.end()) return response;
  const std::size_t bytes = std::stoul(length->second);
  if (!Need(bytes)) ADD_FAILURE() << "the body ends after " << buffer_.size() << " bytes";
  response.body = buffer_.substr(0, bytes);
  buffer_.erase(0, bytes);
  return response;
}

PlainResponse PlainClient::Get(const std::string& target, const std::string& headers) {
  Send("GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\n" + headers + "\r\n");
  return ReadResponse();
}

PlainResponse PlainClient::Upgrade(const std::string& headers, const std::string& host) {
  Send("GET /ws HTTP/1.1\r\nHost: " + host +
       "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
       "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
       headers + "\r\n");
  return ReadResponse();
}

bool PlainClient::SendFrame(int opcode, const std::string& payload) {
  std::string frame(1, static_cast<char>(0x80 | opcode));
  if (payload.size() < 126) {
    frame += static_cast<char>(0x80 | payload.size());
  } else if (payload.size() < 65536) {
    frame += static_cast<char>(0x80 | 126);
    frame += static_cast<char>(payload.size() >> 8);
    frame += static_cast<char>(payload.size() & 0xff);
  } else {
    frame += static_cast<char>(0x80 | 127);
    for (int shift = 56; shift >= 0; shift -= 8) {
      frame += static_cast<char>(static_cast<std::uint64_t>(payload.size()) >> shift & 0xff);
    }
  }
  return Send(frame + std::string(4, '\0') + payload);  // a mask of zeros
}

PlainClient::Message PlainClient::ReadMessage() {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(kPatience_s);
  while (std::chrono::steady_clock::now() < deadline) {  // pings come for ever
    if (!Need(2)) return {};
    const int opcode = buffer_[0] & 0x0f;
    std::size_t length = buffer_[1] & 0x7f, head = 2;
    const int more = length == 126 ? 2 : length == 127 ? 8 : 0;
    if (!Need(2 + more)) return {};
    if (more > 0) length = 0;
    for (int i = 0; i < more; ++i, ++head) {
      length = length << 8 | static_cast<unsigned char>(buffer_[head]);
    }
    if (!Need(head + length)) return {};
    Message message{opcode, buffer_.substr(head, length)};
    buffer_.erase(0, head + length);
    if (opcode != 9) return message;
    SendFrame(10, message.payload);
  }
  return {};
}

nlohmann::json PlainClient::ReadUntil(const std::function<bool(const nlohmann::json&)>& wanted) {
  for (;;) {
    const Message message = ReadMessage();
    if (message.opcode == 0 || message.opcode == 8) return nullptr;
    if (message.opcode != 1) continue;
    nlohmann::json json = nlohmann::json::parse(message.payload, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << message.payload;
    if (wanted(json)) return json;
  }
}

nlohmann::json PlainClient::ReadType(const std::string& type) {
  return ReadUntil([&type](const nlohmann::json& json) { return json.value("type", "") == type; });
}

}  // namespace latticeworld
