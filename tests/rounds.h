// How often something is tried at random.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FFF_IS_SANITIZED true
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FFF_IS_SANITIZED true
#endif
#endif
#ifndef FFF_IS_SANITIZED
#define FFF_IS_SANITIZED false
#endif

namespace fff::test {

/// A tenth where sanitizers make each try twenty times as long.
constexpr int rounds(int count)
{
    return FFF_IS_SANITIZED ? (count + 9) / 10 : count;
}

} // namespace fff::test
